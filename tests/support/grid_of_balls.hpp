// SPDX-License-Identifier: GPL-3.0-or-later
// A file of balls whose empty space is a network of cubes.
#pragma once

#include <cstdio>
#include <string>

namespace alphascope::testing {

// XYZR with layers of 3 x 3 balls of radius 0.3 Å, 2.5 Å apart. With a solvent radius of 1 Å all
// squares of the grid are open.
inline std::string grid_of_balls(int layers = 3) {
  std::string balls;
  for (int n = 0; n < 9 * layers; ++n) {
    char line[100];
    std::snprintf(line, sizeof line, "%.1f %.1f %.1f 0.3\n", 2.5 * (n / 9), 2.5 * (n / 3 % 3),
                  2.5 * (n % 3));
    balls += line;
  }
  return balls;
}

}  // namespace alphascope::testing
