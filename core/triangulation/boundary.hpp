// The boundary of what the tetrahedra of an alpha complex fill, as closed surfaces for programs
// that need solids: printers, Blender, CGAL. Singular triangles, edges and vertices enclose
// nothing, and are no part of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Tetrahedra that hang together by whole triangles. Its surface has an outer sheet and one more
// around each cavity in it; those are seen from inside the cavity.
struct BoundarySolid {
  std::uint32_t first_vertex = 0, vertices = 0;     // in Boundary::vertices
  std::uint32_t first_triangle = 0, triangles = 0;  // in Boundary::triangles
  std::uint32_t tetrahedra = 0;
  double volume_cubic_units = 0;  // of its tetrahedra, cubic lattice units; rounded once
};

// The centre of a ball or, where `other` is another one, the middle between both centres.
struct BoundaryVertex {
  BallIndex ball, other;
  friend bool operator==(const BoundaryVertex&, const BoundaryVertex&) = default;
};

// Every side of a triangle is that of exactly one other triangle, which goes along it in the other
// direction; no two such pairs share both ends; and the triangles around a vertex form one fan.
// Where solids touch, or one touches itself, at a ball only, several vertices are at that ball.
// Where a solid touches itself along a whole edge, the edge has a vertex in its middle as well.
struct Boundary {
  std::vector<BoundaryVertex> vertices;
  // Counterclockwise when seen from outside the tetrahedra; indices into `vertices`.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<BoundarySolid> solids;  // the largest volume first
};

// Å.
RealPoint place_angstrom(const BallSet& balls, const BoundaryVertex& vertex);

// The same for any number of threads. Throws Cancelled, and std::length_error for more tetrahedra
// than can be counted.
Boundary make_boundary(const BallSet& balls, const Simplices<4>& tetrahedra,
                       const RunContext& context = {});

}  // namespace alphascope
