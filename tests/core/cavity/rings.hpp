// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes made of rings of balls, with known widths.
#pragma once

#include <cmath>
#include <numbers>

#include "core/geometry/ball_set.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

inline BallSet no_balls() {
  BallSet balls;
  balls.lattice.digits = 3;
  return balls;
}

// Adds a ring around the z axis. In its plane the axis has a clearance of `distance` - `radius`
// (Å).
inline void add_ring(BallSet& balls, int count, double distance, double z, double radius) {
  for (int n = 0; n < count; ++n) {
    const double angle = 2 * std::numbers::pi * n / count + 0.1;
    add_ball(balls, static_cast<int>(std::lround(1000 * distance * std::cos(angle))),
             static_cast<int>(std::lround(1000 * distance * std::sin(angle))),
             static_cast<int>(std::lround(1000 * z)), static_cast<int>(std::lround(1000 * radius)));
  }
}

// Adds a tube without holes, with an inner radius of 4 Å.
inline void add_tube(BallSet& balls, int low_z, int high_z) {
  for (int z = low_z; z <= high_z; ++z) add_ring(balls, 24, 6, z, 2);
}

}  // namespace alphascope::testing
