// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of a ball grown by solvent radius and alpha.
#pragma once

#include <algorithm>
#include <cmath>

namespace alphascope {

// sqrt((radius + solvent radius)² + alpha), in Å with alpha in Å²; 0 where the grown ball is empty.
// For display and drawing only: membership is decided on the lattice.
inline double grown_radius(double radius, double solvent_radius, double alpha) {
  const double with_solvent = radius + solvent_radius;
  return std::sqrt(std::max(0.0, with_solvent * with_solvent + alpha));
}

}  // namespace alphascope
