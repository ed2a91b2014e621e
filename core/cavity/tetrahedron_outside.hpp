// SPDX-License-Identifier: GPL-3.0-or-later
// The part outside the balls of one tetrahedron not in K_alpha, and of one triangle of a mouth.
// Computed by angle-weighted inclusion-exclusion over the faces that are in K_alpha. If balls poke
// through faces, only the sum over all tetrahedra around them is right. Lengths are in lattice
// units.
#pragma once

#include <array>
#include <cstdint>

#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"

namespace alphascope {

// The faces that are in K_alpha, as bits. Balls go by their numbers, triangles by the opposite
// ball. Edges of a tetrahedron are 01, 02, 03, 12, 13, 23. Edges of a triangle are 12, 02, 01: by
// the opposite ball.
struct FacesIn {
  std::uint32_t balls = 0, edges = 0, triangles = 0;
};

struct OutsidePart {
  double whole;                // volume of the tetrahedron
  double volume;               // volume outside the balls
  std::array<double, 4> area;  // area of each ball's sphere
  double arc;                  // length of the arcs in which two spheres meet
  std::uint32_t corners;
  // The offsets of arcs and corners: within the solvent radius of them, between the directions to
  // their balls' centres. If one of these balls is smaller than the solvent radius, the offset ends
  // at the line or plane through the centres. So no offset reaches beyond the centre of such a
  // ball, and no part counts twice there.
  double offset_volume, offset_area;
  double offset_overlap;  // the part of offset_area across the axes of the arcs; negative
};
OutsidePart outside_part(const GrownBall (&ball)[4], const FacesIn& in, double solvent);

// Area and rim of a triangle's part outside the discs in which the balls meet its plane.
struct MouthPart {
  double area = 0, length = 0;
};
MouthPart mouth_part(const GrownBall (&ball)[3], const FacesIn& in);

}  // namespace alphascope
