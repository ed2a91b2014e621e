// SPDX-License-Identifier: GPL-3.0-or-later
// Reasons why a view shows nothing useful although there are balls.
#pragma once

#include <cstdint>

namespace alphascope {

enum class ViewProblem : std::uint8_t {
  none,
  nothing_in_view,
  inside_a_ball,
  cut_away,
  all_hidden
};

}  // namespace alphascope
