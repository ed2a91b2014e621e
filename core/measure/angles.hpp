// Distances and angles between points of the lattice: what people measure between atoms. Whether an
// angle is defined, and its sign, are decided in whole numbers; the values are doubles, right to
// their last digits but one.
#pragma once

#include <optional>

#include "core/geometry/lattice.hpp"

namespace alphascope {

double distance_on_lattice(const LatticePoint& a, const LatticePoint& b);  // lattice units

// Degrees, 0 to 180: at b between the lines to a and c. None where a or c coincides with b.
std::optional<double> angle_degrees(const LatticePoint& a, const LatticePoint& b,
                                    const LatticePoint& c);

// Degrees, above -180 up to 180: the turn about the line from b to c that takes a's side onto d's,
// positive where it is clockwise to somebody who looks from b to c (IUPAC, "Basic terminology of
// stereochemistry", 1996: torsion angle). None where a, b, c or b, c, d lie on a line.
std::optional<double> dihedral_degrees(const LatticePoint& a, const LatticePoint& b,
                                       const LatticePoint& c, const LatticePoint& d);

}  // namespace alphascope
