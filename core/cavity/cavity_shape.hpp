// What of a cavity can be drawn.
#pragma once

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// The triangles around cavity `index` of `found`: those of its tetrahedra beyond which there is
// none of them. They close, but for the mouths' triangles, which are among them.
Simplices<3> cavity_surface(const CavityGround& ground, const Cavities& found, std::uint32_t index);

// The rims of its mouths: the edges that only one triangle of a mouth has.
Simplices<2> mouth_rims(const CavityGround& ground, const Cavity& cavity);

// The middle of its deepest sink, Å: a place inside it.
RealPoint deepest_place_angstrom(const CavityGround& ground, const Cavity& cavity);

}  // namespace alphascope
