// SPDX-License-Identifier: GPL-3.0-or-later
// Points and lines that the user draws at points in space, with texts beside them.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace alphascope {

struct PlacedMark {
  std::array<double, 3> from{}, to{};  // Å, in the coordinates of the file; equal: a point
  std::string text;                    // beside a point, or in the middle of a line; may be empty
  bool is_point() const { return from == to; }
  friend bool operator==(const PlacedMark&, const PlacedMark&) = default;
};
using PlacedMarks = std::vector<PlacedMark>;
inline constexpr std::size_t kMostMarks = 1000;
inline constexpr std::size_t kLongestMarkText = 200;  // bytes

}  // namespace alphascope
