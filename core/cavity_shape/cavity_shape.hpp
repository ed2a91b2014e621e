// What of a cavity can be drawn.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Face `face` of a tetrahedron.
struct OuterFace {
  std::uint32_t tetrahedron, face;
};
// What is around cavity `index` of `found`: the faces of its tetrahedra beyond which there is none
// of them. They close; the triangles of its mouths are among them.
std::vector<OuterFace> outer_faces(const CavityGround& ground, const Cavities& found,
                                   std::uint32_t index);
// The same as balls.
Simplices<3> cavity_surface(const CavityGround& ground, const Cavities& found, std::uint32_t index);

// The rims of its mouths: the edges that only one triangle of a mouth has.
Simplices<2> mouth_rims(const CavityGround& ground, const Cavity& cavity);

// The middle of its deepest sink, Å: a place inside it.
RealPoint deepest_place_angstrom(const CavityGround& ground, const Cavity& cavity);

}  // namespace alphascope
