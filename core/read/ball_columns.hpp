// Which columns of a table of balls hold x, y, z and r. Programs put a number, a name, or both,
// before them or behind, and no heading says so.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/files/line_reader.hpp"

namespace alphascope {

struct BallColumns {
  std::size_t labels = 0;  // fields before x
  bool numbered = false;   // the one label is a number of the ball
};

// The fields of a line of balls before any comment.
std::vector<std::string_view> ball_fields(std::string_view data);

bool is_number(std::string_view text);

// From the first ball and, where that is not enough, all after it: `data` is the first ball's line
// and `rest` reads the lines behind it. Throws ReadError where two readings are left.
BallColumns find_ball_columns(const std::filesystem::path& source, std::string_view data,
                              LineReader rest);

}  // namespace alphascope
