#include "core/geometry/ball_set.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace alphascope {

BallSet with_solvent(const BallSet& balls, double solvent_radius_angstrom) {
  const double units = std::round(solvent_radius_angstrom * balls.lattice.units_per_angstrom());
  if (!(units >= 0 && units <= kMaxLatticeRadius)) {
    throw std::invalid_argument("solvent radius " + std::to_string(solvent_radius_angstrom) +
                                " Å is negative or too large; use a value from 0 to 100 Å");
  }
  BallSet grown = balls;
  for (std::int32_t& radius : grown.radii) {
    const double sum = radius + units;
    if (sum > kMaxLatticeRadius) {
      throw std::invalid_argument("solvent radius " + std::to_string(solvent_radius_angstrom) +
                                  " Å makes a ball larger than the lattice of this file holds");
    }
    radius = static_cast<std::int32_t>(sum);
  }
  return grown;
}

}  // namespace alphascope
