// SPDX-License-Identifier: GPL-3.0-or-later
// Texts on progress and on the time left.
#include "ui/scene/picture/step_text.hpp"

#include <cmath>

namespace alphascope {
namespace {

std::string time_left(double seconds) {
  const long long whole = std::llround(seconds);
  constexpr long long kMinute = 60;
  if (whole < kMinute) return std::to_string(whole) + " s left";
  return std::to_string(whole / kMinute) + " min " + std::to_string(whole % kMinute) + " s left";
}

}  // namespace

std::string step_text(const char* what, int step, int of, double seconds) {
  const std::string text = what + (" " + std::to_string(step + 1)) + " of " + std::to_string(of);
  return step == 0 ? text : text + ", " + time_left(seconds / step * (of - step));
}

}  // namespace alphascope
