// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates of a point as text.
#pragma once

#include <string>

#include "core/geometry/real_point.hpp"
#include "core/text/fixed_digits.hpp"

namespace alphascope {

// "1.000, -2.500, 0.000": three decimals, without the unit.
inline std::string point_text(const RealPoint& p) {
  return fixed_digits(p.x, 3) + ", " + fixed_digits(p.y, 3) + ", " + fixed_digits(p.z, 3);
}

}  // namespace alphascope
