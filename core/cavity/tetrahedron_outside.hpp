// SPDX-License-Identifier: GPL-3.0-or-later
// The part outside the balls of one tetrahedron not in K_alpha, and of one triangle of a mouth.
// Computed by angle-weighted inclusion-exclusion over the faces that are in K_alpha. If balls poke
// through faces, only the sum over all tetrahedra around them is right. Lengths are in lattice
// units.
#pragma once

#include "core/cavity/outside_body.hpp"
#include "core/complex/outside_part.hpp"
#include "core/measure/ball_geometry.hpp"

namespace alphascope {

OutsidePart outside_part(const GrownBall (&ball)[4], const FacesIn& in, double solvent);

// Area and rim of a triangle's part outside the discs in which the balls meet its plane.
struct MouthPart {
  double area = 0, length = 0;
};
MouthPart mouth_part(const GrownBall (&ball)[3], const FacesIn& in);

}  // namespace alphascope
