// The place between three balls that is equally far from their surfaces: where a passage between
// them is narrowest. And that between two balls in a plane.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

struct EqualClearance {
  bool found = false;        // not when the centres are on one line, or one ball hides another
  RealPoint place_angstrom;  // in the plane of the centres
  double clearance_angstrom = 0;
};

EqualClearance equal_clearance(const BallSet& balls, const std::array<BallIndex, 3>& three);

// Between two balls, in a plane: where one that keeps to the plane gets stuck.
struct Plane {
  RealPoint point;   // lattice units
  RealPoint normal;  // unit vector
};
EqualClearance equal_clearance_in_plane(const BallSet& balls, const std::array<BallIndex, 2>& two,
                                        const Plane& plane);

}  // namespace alphascope
