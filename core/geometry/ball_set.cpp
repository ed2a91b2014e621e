// SPDX-License-Identifier: GPL-3.0-or-later
// Balls on finer lattices, and balls grown by a solvent radius.
#include "core/geometry/ball_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

// The digits that a length (Å) needs. If it has more than the finest lattice, the digits of that
// lattice.
int digits_of(double length_angstrom, int at_least) {
  int digits = at_least;
  while (digits < kMaxLatticeDigits && !Lattice{digits}.holds(length_angstrom)) ++digits;
  return digits;
}

}  // namespace

int finest_digits(const BallSet& balls, int wanted, double growth_angstrom) {
  double coordinate = 0, radius = 0;  // lattice units
  for (const LatticePoint& p : balls.centres) {
    coordinate = std::max({coordinate, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  for (const std::int32_t r : balls.radii) radius = std::max<double>(radius, r);
  const auto fits = [&](int digits) {
    const double factor = std::pow(10.0, digits - balls.lattice.digits);
    const double growth = Lattice{digits}.nearest_units(growth_angstrom);
    return coordinate * factor <= kMaxLatticeCoordinate &&
           radius * factor + growth <= kMaxLatticeRadius;
  };
  int digits = std::max(wanted, balls.lattice.digits);
  while (digits > balls.lattice.digits && !fits(digits)) --digits;
  return digits;
}

BallSet on_finer_lattice(const BallSet& balls, int digits) {
  BallSet finer = balls;
  std::int32_t factor = 1;
  for (; finer.lattice.digits < digits; ++finer.lattice.digits) factor *= 10;
  if (factor == 1) return finer;
  for (LatticePoint& p : finer.centres) p = {p.x * factor, p.y * factor, p.z * factor};
  for (std::int32_t& radius : finer.radii) radius *= factor;
  return finer;
}

BallSet with_solvent(const BallSet& balls, double solvent_radius_angstrom) {
  const double coarse = balls.lattice.nearest_units(solvent_radius_angstrom);
  if (!(solvent_radius_angstrom >= 0 && coarse <= kMaxLatticeRadius)) {
    throw std::invalid_argument("solvent radius " + std::to_string(solvent_radius_angstrom) +
                                " Å is negative or too large; use a value from 0 to 100 Å");
  }
  const int wanted = digits_of(solvent_radius_angstrom, balls.lattice.digits);
  BallSet grown = on_finer_lattice(balls, finest_digits(balls, wanted, solvent_radius_angstrom));
  const double units = grown.lattice.nearest_units(solvent_radius_angstrom);
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
