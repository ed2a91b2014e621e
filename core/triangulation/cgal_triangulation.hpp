// A triangulation made by CGAL's Regular_triangulation_3. CGAL itself is seen by
// cgal_triangulation.cpp only; alpha values are the filtration's business.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// `threads` changes only the time: CGAL's parallel code runs from 3 on, in the caller's task arena;
// its sequential code below. Throws Cancelled, and std::length_error for more balls or tetrahedra
// than can be handled.
Triangulation make_triangulation(const BallSet& balls, int threads, const RunContext& context = {});

}  // namespace alphascope
