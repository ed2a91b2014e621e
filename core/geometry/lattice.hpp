// The decimal lattice on which all geometry is exact: coordinates and radii are integers, in units
// of 10^-digits Å. Holds the unit, the bounds and the conversion of alpha; reading text onto the
// lattice is core/io's business.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

// Bounds that keep every exact predicate inside its fixed integer width (see exact_rho.hpp):
// coordinate differences fit 31 bits, weights are exact as doubles, power differences fit int64.
inline constexpr std::int32_t kMaxLatticeCoordinate = (1 << 29) - 1;
inline constexpr std::int32_t kMaxLatticeRadius = (1 << 26) - 1;

// Files with fewer digits still get this lattice, so that typed solvent radii are on it.
inline constexpr int kMinLatticeDigits = 3;

// Files with more digits have them from a program, not from a measurement; this leaves room for
// radii up to 67 Å, which the solvent radius and the radii sets need.
inline constexpr int kMaxLatticeDigits = 6;

struct LatticePoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

struct Lattice {
  int digits =
      kMinLatticeDigits;  // 0 to 6: the unit is 10^-digits Å, less fine for huge coordinates

  double units_per_angstrom() const { return std::pow(10.0, digits); }
  double unit_angstrom() const { return 1.0 / units_per_angstrom(); }

  double angstrom(double units) const { return units / units_per_angstrom(); }
  double square_angstrom(double square_units) const {
    return square_units / std::pow(10.0, 2 * digits);
  }

  // The multiple of the unit that is nearest to a length (Å), as a whole number.
  double nearest_units(double length_angstrom) const {
    return std::round(length_angstrom * units_per_angstrom());
  }
  // Whether a decimal length, such as 1.4, is a multiple of the unit. Both sides are the double
  // nearest to one decimal number when it is.
  bool holds(double length_angstrom) const {
    return angstrom(nearest_units(length_angstrom)) == length_angstrom;
  }

  // alpha in square lattice units: exact, as alpha is, and what every engine and CGAL compare with.
  LatticeAlpha alpha_on_lattice(const Alpha& alpha) const;
  // The other way; of a double, by the shortest decimal that says which one it is.
  Alpha alpha_angstrom2(const LatticeAlpha& alpha) const;
  friend bool operator==(const Lattice&, const Lattice&) = default;
};

}  // namespace alphascope
