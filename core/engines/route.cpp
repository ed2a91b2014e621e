// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates the cost of clipping and of triangulating, in microseconds of one thread per ball. The
// constants are fits to 1K4C (16,068 balls) on one core of an AMD EPYC. Those of clipping are for
// AVX-512, with alpha 0 to 8 Å² and 5.7 to 47 neighbours a ball.
#include "core/engines/route.hpp"

#include <algorithm>
#include <cmath>

#include "core/dual_edge/cpu_dual_edges.hpp"

namespace alphascope {
namespace {

double clipping_cost(const NeighbourMoments& m, bool tetrahedra_only) {
  return tetrahedra_only ? 0.1 + 0.02 * m.mean + 0.0043 * m.mean_square
                         : 0.1 + 0.165 * m.mean + 0.0023 * m.mean_square;
}
constexpr std::size_t kCostSamples = 256;

constexpr double kTriangulationCost = 2.2;
// Costs after the triangulation: ortho-radii of the tetrahedra, or alpha values of all simplices.
constexpr double kTetrahedraCost = 0.2, kAlphaValuesCost = 3;
double triangulating_cost(const RouteInput& question) {
  return (question.has_triangulation ? 0 : kTriangulationCost) +
         (question.tetrahedra_only ? kTetrahedraCost : kAlphaValuesCost);
}
// Clipping scales with the threads. The triangulation scales less.
double triangulating_speed_up(int threads) {
  return std::pow(threads, 0.7);
}

// False where a search for neighbours would test nearly all balls against all. Clipping is then
// never faster, so no sample is taken.
bool is_local(const UniformGrid& grid) {
  return grid.search_cost() < 2000.0 * static_cast<double>(grid.size()) + 1e6;
}

}  // namespace

// With a longer reach (lattice units), differences of neighbours may exceed the range of the
// clipping kernels.
bool within_clipping_reach(const UniformGrid& grid) {
  constexpr double kMaxClippingReach = 1 << 29;
  const auto largest = std::max_element(grid.reach.begin(), grid.reach.end());
  return largest == grid.reach.end() || 2 * double{*largest} < kMaxClippingReach;
}

Route choose_route(const UniformGrid& grid, const RouteInput& question) {
  if (!is_local(grid) || !within_clipping_reach(grid)) return Route::triangulate;
  const NeighbourMoments moments = sample_neighbours(grid, kCostSamples);
  const double clipping = clipping_cost(moments, question.tetrahedra_only) / question.threads;
  const double triangulating =
      triangulating_cost(question) / triangulating_speed_up(question.threads);
  return clipping < triangulating ? Route::clip_dual_edges : Route::triangulate;
}

}  // namespace alphascope
