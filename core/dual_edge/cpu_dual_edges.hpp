// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the dual-edge engine on the CPU (oneTBB): from balls to K_alpha in the stages of
// the stage table. core/engines/cpu_engine.cpp chooses between this and other routes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Number of dual edges, and how many the filter could not decide; shown to users.
struct DualEdgeStatistics {
  std::size_t dual_edges = 0;  // triangles of balls that meet in pairs
  std::size_t exact = 0;       // of these, decided again in exact integers
};

// Appends all slots whose grown balls may meet the ball in `slot`, ascending by ball index.
// `scratch` is memory for the search.
void find_neighbours(const UniformGrid& grid, std::uint32_t slot, std::vector<std::uint32_t>& found,
                     std::vector<std::uint32_t>& scratch);

// The mean number of neighbours of a ball, and the mean of its square. They come from at most
// `samples` balls spread over the grid. The cost of the dual edges depends on them.
struct NeighbourMoments {
  double mean = 0, mean_square = 0;
};
NeighbourMoments sample_neighbours(const UniformGrid& grid, std::size_t samples);

// Fills the simplices of `complex`, whose alpha_on_lattice and tetrahedra_only are inputs. The grid
// must be made for the same alpha. Appends the stages from kernel I on to the timings. Runs in the
// calling task arena. Throws Cancelled, std::bad_alloc.
DualEdgeStatistics compute_by_dual_edges(const BallSet& balls, const UniformGrid& grid,
                                         const RunContext& context, StageTimer& timer,
                                         AlphaComplex& complex);

}  // namespace alphascope
