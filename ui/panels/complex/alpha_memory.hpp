// What the alpha panel remembers between frames.
#pragma once

#include "core/document/alpha/alpha_slider.hpp"

namespace alphascope {

struct AlphaMemory {
  // Of a drag in which Shift was pressed: from where on the mouse moves alpha, and how finely.
  bool relative = false, fine = false;
  double from_place = 0;
  float from_x = 0;  // pixels
};

}  // namespace alphascope
