// The triangles of a triangulation as gates between cavities: from which alpha on each is closed,
// and in which order a falling alpha opens them.
#pragma once

#include "core/cavity/cavities.hpp"

namespace alphascope {

// In K_alpha from this alpha on, the ortho-radius of a simplex: square lattice units, rounded to
// the nearest float.
struct Gate {
  float closes = 0;
  std::uint32_t triangle = 0;
  // Whose ortho-radius it is: a tetrahedron's; of kNone the triangle's own.
  std::uint32_t tetrahedron = Cavities::kNone;
};
Gate gate_of(const CavityGround& ground, std::uint32_t triangle);

// Does a falling alpha open `a` before `b`? Exactly; of those that open at once, the one that comes
// first by the places of its centres.
bool opens_before(const CavityGround& ground, const Gate& a, const Gate& b);

}  // namespace alphascope
