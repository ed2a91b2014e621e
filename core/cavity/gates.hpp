// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a triangulation as gates between cavities. Each is closed from some alpha on. A
// falling alpha opens them in a definite order.
#pragma once

#include "core/cavity/cavities.hpp"

namespace alphascope {

// The triangle is in K_alpha from this alpha on: the ortho-radius of the decisive simplex, which is
// the triangle or a tetrahedron at it. Square lattice units, rounded to the nearest float.
struct Gate {
  float closes = 0;
  std::uint32_t triangle = 0;
  // The decisive simplex if it is a tetrahedron. kNone: it is the triangle itself.
  std::uint32_t tetrahedron = Cavities::kNone;
};
Gate gate_of(const CavityGround& ground, std::uint32_t triangle);

// Returns whether a falling alpha opens `a` before `b`. Exact. Gates that open at the same alpha
// are ordered by the positions of their centres.
bool opens_before(const CavityGround& ground, const Gate& a, const Gate& b);

}  // namespace alphascope
