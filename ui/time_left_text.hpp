// SPDX-License-Identifier: GPL-3.0-or-later
// The time left of a job in words, for window and pictures.
#pragma once

#include <cmath>
#include <string>

namespace alphascope {

// "24 s left", "1 min 40 s left".
inline std::string time_left_text(double seconds) {
  const long long whole = std::llround(seconds);
  constexpr long long kMinute = 60;
  if (whole < kMinute) return std::to_string(whole) + " s left";
  return std::to_string(whole / kMinute) + " min " + std::to_string(whole % kMinute) + " s left";
}

}  // namespace alphascope
