// SPDX-License-Identifier: GPL-3.0-or-later
// The last part of the certificate of a triangulation: its hull. The device checks all else:
//
//  1. No tetrahedron is flat. Each face has two tetrahedra, whose other balls are on opposite sides
//     of it, or it is a facet of the hull. So the number of tetrahedra that cover a point changes
//     only where the point crosses a facet of the hull.
//  2. The facets of the hull are a closed surface, convex at each edge. A point within the first
//     tetrahedron is behind all of them, and one ray from it meets only one. So the surface is the
//     boundary of a convex body, and encloses each of its points once (K. Mehlhorn et al., Checking
//     geometric programs or verification of geometric structures, Comput. Geom. 12, 1999). So the
//     tetrahedra cover each point of that body once: they triangulate it.
//  3. At each inner face the ball of one tetrahedron is not in conflict with the other tetrahedron.
//     So the triangulation is the regular one of its vertices (H. Edelsbrunner, Geometry and
//     Topology for Mesh Generation, 2001, chapters 2 and 5).
//  4. Each other ball is in a tetrahedron and not in conflict with it, so it is hidden.
#pragma once

#include "core/complex/triangulation.hpp"

namespace alphascope {

struct BallSet;

// Checks step 2, in integers. `inside`: the balls of the first tetrahedron.
bool encloses_once(const BallSet& balls, const std::vector<HullFacet>& hull,
                   const std::array<BallIndex, 4>& inside);
inline bool encloses_once(const BallSet& balls, const Triangulation& triangulation) {
  return !triangulation.tetrahedra.empty() &&
         encloses_once(balls, triangulation.hull, triangulation.tetrahedra[0]);
}

}  // namespace alphascope
