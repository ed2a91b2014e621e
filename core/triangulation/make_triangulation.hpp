// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the regular triangulation of any set of balls on the CPU.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// By insertion (core/insertion) where the centres span space, else by CGAL. `threads` changes only
// the time; 0 stands for those of the caller's task arena, in which it works. The result has a
// report. Throws Cancelled, std::bad_alloc, and std::length_error for more balls or tetrahedra than
// can be handled.
Triangulation make_triangulation(const BallSet& balls, int threads, const RunContext& context = {});

}  // namespace alphascope
