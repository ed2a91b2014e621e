// Makes a regular triangulation with CGAL's Regular_triangulation_3. Only cgal_triangulation.cpp
// includes CGAL; alpha values are in filtration.hpp.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// `threads` changes only the time: 3 or more run CGAL's parallel code, in the caller's task arena;
// fewer run its sequential code. Throws Cancelled, and std::length_error for more balls or
// tetrahedra than can be handled.
Triangulation make_triangulation(const BallSet& balls, int threads, const RunContext& context = {});

}  // namespace alphascope
