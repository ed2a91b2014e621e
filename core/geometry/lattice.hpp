// SPDX-License-Identifier: GPL-3.0-or-later
// The decimal lattice on which all geometry is exact: coordinates and radii are integers, in units
// of 10^-digits Å. This file has the unit and the conversion of alpha; lattice_point.hpp has the
// bounds. core/read reads text onto the lattice.
#pragma once

#include <cmath>
#include <cstdint>

namespace alphascope {

class Alpha;
struct LatticeAlpha;

// Files with fewer digits get this lattice too, so that typed solvent radii are on it.
inline constexpr int kMinLatticeDigits = 3;

// If a file has more digits, they come from a program and not from a measurement. Six digits leave
// room for radii up to 67 Å, which the solvent radius and the radii sets need.
inline constexpr int kMaxLatticeDigits = 6;

struct Lattice {
  // 0 to 6: the unit is 10^-digits Å, coarser for huge coordinates.
  int digits = kMinLatticeDigits;

  double units_per_angstrom() const { return std::pow(10.0, digits); }
  double unit_angstrom() const { return 1.0 / units_per_angstrom(); }

  double angstrom(double units) const { return units / units_per_angstrom(); }
  double square_angstrom(double square_units) const {
    return square_units / std::pow(10.0, 2 * digits);
  }

  // The multiple of the unit nearest to a length (Å), as an integer.
  double nearest_units(double length_angstrom) const {
    return std::round(length_angstrom * units_per_angstrom());
  }
  // Is a decimal length (Å), such as 1.4, a multiple of the unit? If so, both sides are the double
  // nearest to the same decimal.
  bool holds(double length_angstrom) const {
    return angstrom(nearest_units(length_angstrom)) == length_angstrom;
  }

  // alpha in square lattice units. It is exact, and every engine and CGAL compare with it.
  LatticeAlpha alpha_on_lattice(const Alpha& alpha) const;
  // Alpha in Å² from square lattice units. A double stands for the shortest decimal that reads as
  // it.
  Alpha alpha_angstrom2(const LatticeAlpha& alpha) const;
  friend bool operator==(const Lattice&, const Lattice&) = default;
};

}  // namespace alphascope
