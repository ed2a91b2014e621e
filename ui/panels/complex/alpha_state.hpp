// The state of the section on alpha between frames.
#pragma once

namespace alphascope {

struct AlphaState {
  // State of a drag in which Shift was pressed: the place and the pixel from which the mouse moves
  // alpha, and whether it moves it finely.
  bool relative = false, fine = false;
  double from_place = 0;
  float from_x = 0;  // pixels
};

}  // namespace alphascope
