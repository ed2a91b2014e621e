// CGAL's regular (weighted Delaunay) triangulation of a BallSet, copied out into plain arrays. CGAL
// itself is seen by cgal_triangulation.cpp only; alpha values are the filtration's business.
#pragma once

#include <array>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// The maximal simplices; each one's vertices ascend, the simplices come in no particular order.
struct RegularTriangulation {
  int dimension = -1;               // of the affine hull of the centres: -1 (no ball) to 3
  Simplices<4> tetrahedra;          // only in dimension 3
  Simplices<3> triangles;           // only in dimension 2
  Simplices<2> edges;               // only in dimension 1
  std::vector<BallIndex> vertices;  // ascending, any dimension
  std::vector<BallIndex> hidden;    // ascending: the balls that are no vertex
};

// Equal powers are decided by CGAL's symbolic perturbation; of coincident centres the largest ball,
// then the one of lowest index, is inserted. So the result is unique: it depends neither on the
// order of insertion nor on `threads` (CGAL's parallel code from 3 on, which then runs in the
// caller's task arena; its sequential code below). Throws Cancelled.
RegularTriangulation triangulate(const BallSet& balls, int threads, const RunContext& context);

}  // namespace alphascope
