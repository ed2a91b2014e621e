// SPDX-License-Identifier: GPL-3.0-or-later
// Chambers in a row: cubes of balls with holes of known widths in their walls.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

// Balls are on a cubic grid of 4 Å, 4 squares wide and high. A ball is missing in each wall between
// two chambers. Four balls are missing in each other wall of a chamber, except at the ends of the
// row. The balls nearest to a hole have radius r and are 4 Å away. So the hole is closed from alpha
// 16 - r² on, or with a solvent radius of 4 - r. `between`: for each wall between two chambers, the
// radius of the balls nearest to its hole (0.1 Å). `outer`: the radius of all other balls.
inline BallSet chambers_in_a_row(const std::vector<int>& between, int outer = 30) {
  BallSet balls;
  balls.lattice.digits = 1;
  const int last = 4 * (static_cast<int>(between.size()) + 1);
  const auto odd = [](int a, int b) { return a % 2 == 1 && b % 2 == 1; };
  for (int x = 0; x <= last; ++x) {
    for (int y = 0; y <= 4; ++y) {
      for (int z = 0; z <= 4; ++z) {
        const bool at_y = y == 0 || y == 4, at_z = z == 0 || z == 4;
        const bool wall = x % 4 == 0, inner_wall = wall && x > 0 && x < last;
        if (!wall && !at_y && !at_z) continue;
        if ((at_y && odd(x, z)) || (at_z && odd(x, y))) continue;
        if (inner_wall && y == 2 && z == 2) continue;
        const bool nearest = inner_wall && !at_y && !at_z && (y == 2) != (z == 2);
        add_ball(balls, 40 * x, 40 * y, 40 * z,
                 nearest ? between[static_cast<std::size_t>(x / 4 - 1)] : outer);
      }
    }
  }
  return balls;
}

}  // namespace alphascope::testing
