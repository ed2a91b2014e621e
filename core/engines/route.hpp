// Which way the CPU engine goes to a complex that it cannot threshold: the one place that knows
// what the ways cost.
#pragma once

#include "core/neighbours/uniform_grid.hpp"

namespace alphascope {

enum class Route { clip_dual_edges, triangulate };

struct RouteQuestion {
  int threads = 1;
  bool tetrahedra_only = false;
  bool has_triangulation = false;  // so that only what comes after it is to be paid
};

// Can dual edges be clipped at all: do the differences of neighbours stay within the kernels'
// range?
bool within_clipping_reach(const UniformGrid& grid);

// Only the time depends on the choice, never the result. Works in the caller's task arena.
Route choose_route(const UniformGrid& grid, const RouteQuestion& question);

}  // namespace alphascope
