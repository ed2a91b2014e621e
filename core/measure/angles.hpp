// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and angles between points of the lattice, such as people measure between atoms.
// Integers decide whether an angle is defined, and its sign. The values are doubles, correct to the
// last digit but one.
#pragma once

#include <optional>

#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

double distance_on_lattice(const LatticePoint& a, const LatticePoint& b);  // lattice units

// The angle at b between the lines to a and c, 0 to 180 degrees. Empty if a or c coincides with b.
std::optional<double> angle_degrees(const LatticePoint& a, const LatticePoint& b,
                                    const LatticePoint& c);

// The torsion angle, above -180 and at most 180 degrees: the turn about the line from b to c that
// takes a's side onto d's. It is positive if the turn is clockwise for a viewer who looks from b to
// c (IUPAC, "Basic terminology of stereochemistry", 1996: torsion angle). Empty if a, b, c or b, c,
// d are on a line.
std::optional<double> dihedral_degrees(const LatticePoint& a, const LatticePoint& b,
                                       const LatticePoint& c, const LatticePoint& d);

}  // namespace alphascope
