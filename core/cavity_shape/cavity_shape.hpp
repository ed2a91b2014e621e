// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a cavity that can be drawn.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Face number `face` of a tetrahedron, opposite that vertex.
struct OuterFace {
  std::uint32_t tetrahedron, face;
};
// The outer faces of cavity `index` of `found`: only one side is one of its tetrahedra. They form a
// closed surface that includes the mouths' triangles.
std::vector<OuterFace> outer_faces(const CavityGround& ground, const Cavities& found,
                                   std::uint32_t index);
// The outer faces as triples of balls.
Simplices<3> cavity_surface(const CavityGround& ground, const Cavities& found, std::uint32_t index);

// The rims of the mouths: edges that belong to only one triangle of a mouth.
Simplices<2> mouth_rims(const CavityGround& ground, const Cavity& cavity);

// The centroid of the deepest sink (Å), a place inside the cavity.
RealPoint deepest_place_angstrom(const CavityGround& ground, const Cavity& cavity);

}  // namespace alphascope
