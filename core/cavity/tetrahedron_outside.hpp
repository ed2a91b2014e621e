// What lies outside the balls in one tetrahedron that is not in K_alpha, by angle-weighted
// inclusion-exclusion over its faces that are in K_alpha, and in one triangle of a mouth. Where
// balls poke through faces, only the sum over all tetrahedra around them is right. Lengths are in
// lattice units.
#pragma once

#include <array>
#include <cstdint>

#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"

namespace alphascope {

// Faces that are in K_alpha, as bits: balls by their numbers, edges 01, 02, 03, 12, 13, 23 (of a
// triangle 12, 02, 01: by the opposite ball), triangles by the opposite ball.
struct FacesIn {
  std::uint32_t balls = 0, edges = 0, triangles = 0;
};

struct OutsidePart {
  double whole = 0;              // volume of the tetrahedron
  double volume = 0;             // of what is outside
  std::array<double, 4> area{};  // of each ball's sphere
  double arc = 0;                // length of the arcs in which two spheres meet
  std::uint32_t corners = 0;
  // What is within the solvent radius of arcs and corners, beyond both or all their balls. Where
  // one of these is smaller than the solvent radius, only as far as their centres, as nothing is
  // beyond the centre of such a ball; then nothing overlaps.
  double offset_volume = 0, offset_area = 0;
  double offset_overlap = 0;  // of the area, what lies across the axes of the arcs: negative
};
OutsidePart outside_part(const GrownBall (&ball)[4], const FacesIn& in, double solvent);

// Of the part of a triangle outside the discs in which the balls meet its plane.
struct MouthPart {
  double area = 0, length = 0;
};
MouthPart mouth_part(const GrownBall (&ball)[3], const FacesIn& in);

}  // namespace alphascope
