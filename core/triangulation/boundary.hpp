// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of the union of the tetrahedra of an alpha complex, as closed surfaces for programs
// that need solids: printers, Blender, CGAL. Singular triangles, edges and vertices enclose nothing
// and are left out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// Tetrahedra that are connected through triangles. The surface of a solid has an outer sheet, and
// another sheet around each void. The triangles of the latter face into the void.
struct BoundarySolid {
  std::uint32_t first_vertex = 0, vertices = 0;     // in Boundary::vertices
  std::uint32_t first_triangle = 0, triangles = 0;  // in Boundary::triangles
  std::uint32_t tetrahedra = 0;
  double volume_cubic_units = 0;  // cubic lattice units, exact but for one rounding
};

// The centre of a ball. If `other` is another ball, the middle between both centres.
struct BoundaryVertex {
  BallIndex ball, other;
  friend bool operator==(const BoundaryVertex&, const BoundaryVertex&) = default;
};

// Every side of a triangle belongs to exactly one other triangle, which has it in the opposite
// direction. No two such pairs share both ends of their side. The triangles around a vertex form
// one fan. If surfaces touch only at a ball, several vertices are at that ball. If a solid touches
// itself along an edge, that edge has an additional vertex in its middle.
struct Boundary {
  std::vector<BoundaryVertex> vertices;
  // Counterclockwise when seen from outside the tetrahedra; indices into `vertices`.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<BoundarySolid> solids;  // the largest volume first
};

// The position of a vertex in Å.
RealPoint place_angstrom(const BallSet& balls, const BoundaryVertex& vertex);

// Makes the boundary of these tetrahedra. The result does not depend on the number of threads.
// Throws Cancelled, and std::length_error for more tetrahedra than can be counted.
Boundary make_boundary(const BallSet& balls, const Simplices<4>& tetrahedra,
                       const RunContext& context = {});

}  // namespace alphascope
