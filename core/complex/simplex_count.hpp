// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of all simplices of a triangulation. In this header, because the library with the GPU
// engines must take no object of core/triangulation, one of which needs CGAL.
#pragma once

#include <cstdint>

#include "core/complex/triangulation.hpp"

namespace alphascope {

struct SimplexCount {
  std::uint64_t vertices = 0, edges = 0, triangles = 0, tetrahedra = 0;
};
// Counts also the faces that the triangulation does not list. V - E + F - T = 1. Each tetrahedron
// has four faces, which two tetrahedra share, except those of the hull.
inline SimplexCount simplex_count(const Triangulation& t) {
  SimplexCount c;
  c.vertices = t.vertices.size();
  c.tetrahedra = t.tetrahedra.size();
  c.triangles = t.dimension == 2 ? t.triangles.size() : (4 * c.tetrahedra + t.hull.size()) / 2;
  if (t.dimension >= 1) c.edges = c.vertices + c.triangles - c.tetrahedra - 1;
  return c;
}

}  // namespace alphascope
