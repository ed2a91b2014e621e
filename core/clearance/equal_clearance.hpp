// SPDX-License-Identifier: GPL-3.0-or-later
// The place that is equally far from the surfaces of three balls. A passage between them is
// narrowest there. A second function finds the like place between two balls in a plane.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

struct EqualClearance {
  bool found = false;        // false if the centres are on one line or a ball hides another
  RealPoint place_angstrom;  // in the plane of the centres
  double clearance_angstrom = 0;
};

EqualClearance equal_clearance(const BallSet& balls, const std::array<BallIndex, 3>& three);

// The narrowest place between two balls for a sphere whose centre stays in the plane.
struct Plane {
  RealPoint point;   // lattice units
  RealPoint normal;  // unit vector
};
EqualClearance equal_clearance_in_plane(const BallSet& balls, const std::array<BallIndex, 2>& two,
                                        const Plane& plane);

}  // namespace alphascope
