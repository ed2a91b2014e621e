// SPDX-License-Identifier: GPL-3.0-or-later
// How the CPU engine computes a complex for which it has no filtration. Only this file knows the
// costs.
#pragma once

#include "core/neighbours/uniform_grid.hpp"

namespace alphascope {

enum class Route { clip_dual_edges, triangulate };

struct RouteInput {
  int threads = 1;
  bool tetrahedra_only = false;
  // The triangulation is known, or a device makes it in little time. Only the steps after it cost.
  bool has_triangulation = false;
};

// True when the differences of neighbours stay within the clipping kernels' range.
bool within_clipping_reach(const UniformGrid& grid);

// The faster route. The result does not depend on it. Works in the caller's task arena.
Route choose_route(const UniformGrid& grid, const RouteInput& question);

}  // namespace alphascope
