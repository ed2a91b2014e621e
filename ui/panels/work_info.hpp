// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data on running work, which the program fills and the panels show.
#pragma once

#include <cstdint>
#include <string>

namespace alphascope {

struct BadgeInfo {
  enum class State : std::uint8_t { not_compared, comparing, identical, different, failed };
  State state = State::not_compared;
  std::string text;    // "identical to CGAL: 16,445 of 16,445 tetrahedra"
  double seconds = 0;  // since the comparison began
};

// A result that is made while the user goes on working.
struct BackgroundInfo {
  std::string text, detail;  // one line, and its explanation; empty: nothing is made
};

}  // namespace alphascope
