// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the columns x, y, z and r of a table of balls. Programs write a number, a name or both
// before or behind them, without a heading.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/text_files/line_reader.hpp"

namespace alphascope {

struct BallColumns {
  std::size_t labels = 0;  // fields before x
  bool numbered = false;   // the only label is the number of the ball
};

// The fields of a line of balls, without a comment.
std::vector<std::string_view> ball_fields(std::string_view data);

bool is_number(std::string_view text);

// Decides from the first ball, and from all later lines where that is not enough. `data` is the
// line of the first ball, and `rest` reads the lines behind it. Throws ReadError where two readings
// remain.
BallColumns find_ball_columns(const std::filesystem::path& source, std::string_view data,
                              LineReader rest);

}  // namespace alphascope
