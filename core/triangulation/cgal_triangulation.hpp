// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a regular triangulation with CGAL's Regular_triangulation_3. Only cgal_triangulation.cpp
// includes CGAL; alpha values are in filtration.hpp.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// `threads` changes only the time. With three or more, and at least some thousand balls, CGAL's
// parallel code runs in the caller's task arena; else its sequential code runs. Throws Cancelled,
// and std::length_error for more balls or tetrahedra than can be handled.
Triangulation make_cgal_triangulation(const BallSet& balls, int threads,
                                      const RunContext& context = {});

}  // namespace alphascope
