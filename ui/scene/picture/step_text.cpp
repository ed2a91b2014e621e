// SPDX-License-Identifier: GPL-3.0-or-later
// Texts on progress and on the time left.
#include "ui/scene/picture/step_text.hpp"

#include "ui/time_left_text.hpp"

namespace alphascope {

std::string step_text(const char* what, int step, int of, double seconds) {
  const std::string text = what + (" " + std::to_string(step + 1)) + " of " + std::to_string(of);
  return step == 0 ? text : text + ", " + time_left_text(seconds / step * (of - step));
}

}  // namespace alphascope
