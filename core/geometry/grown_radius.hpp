// How a ball grows with the solvent radius and alpha.
#pragma once

#include <algorithm>
#include <cmath>

namespace alphascope {

// sqrt((radius + solvent radius)² + alpha), Å and Å²; 0 where the grown ball is empty. To be shown
// and drawn: what is in a complex is decided on the lattice.
inline double grown_radius(double radius, double solvent_radius, double alpha) {
  const double with_solvent = radius + solvent_radius;
  return std::sqrt(std::max(0.0, with_solvent * with_solvent + alpha));
}

}  // namespace alphascope
