// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a tetrahedron outside all balls, in numbers (core/cavity/tetrahedron_outside.hpp).
#pragma once

#include <cstdint>

namespace alphascope {

// Lengths in lattice units.
struct OutsidePart {
  double whole;           // volume of the tetrahedron
  double volume;          // volume outside the balls
  double area[4];         // area of each ball's sphere
  double arc;             // length of the arcs in which two spheres meet
  std::uint64_t corners;  // points in which three spheres meet; as wide as the rest, without gaps
  // The offsets of arcs and corners: within the solvent radius of them, between the directions to
  // their balls' centres. If one of these balls is smaller than the solvent radius, the offset ends
  // at the line or plane through the centres. So no offset reaches beyond the centre of such a
  // ball, and no part counts twice there.
  double offset_volume, offset_area;
  double offset_overlap;  // the part of offset_area across the axes of the arcs; negative
};

}  // namespace alphascope
