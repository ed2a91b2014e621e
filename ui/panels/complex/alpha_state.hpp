// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the section on alpha between frames.
#pragma once

namespace alphascope {

struct AlphaState {
  // State of a drag in which Shift was pressed (`relative`). Alpha moves from `from_place` as the
  // mouse moves from `from_x`, and a tenth as far while `fine`.
  bool relative = false, fine = false;
  double from_place = 0;
  float from_x = 0;  // pixels
};

}  // namespace alphascope
