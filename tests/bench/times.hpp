// SPDX-License-Identifier: GPL-3.0-or-later
// Wall times for programs that measure.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace alphascope::bench {

using Clock = std::chrono::steady_clock;

inline double milliseconds(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}
inline double median(std::vector<double> values) {  // at least one
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace alphascope::bench
