// The kernels of the dual-edge engine on the CPU (oneTBB): from balls to K_alpha in the stages of
// the stage table. Choosing between this and other routes is core/engines/cpu_engine.cpp's
// business.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// How often the filter could not decide, for display.
struct DualEdgeStatistics {
  std::size_t dual_edges = 0;  // of triangles of balls that meet
  std::size_t exact = 0;       // of these, done again in exact integers
};

// Appends all slots whose grown balls may meet that of `slot`, ascending by ball index. `row_hits`
// is scratch memory.
void find_neighbours(const UniformGrid& grid, std::uint32_t slot, std::vector<std::uint32_t>& found,
                     std::vector<std::uint32_t>& row_hits);

// Mean number of neighbours of a ball and mean of its square, from at most `samples` balls spread
// over the grid: what the cost of the dual edges depends on.
struct NeighbourMoments {
  double mean = 0, mean_square = 0;
};
NeighbourMoments sample_neighbours(const UniformGrid& grid, std::size_t samples);

// Fills the simplices of `complex` (alpha_on_lattice and tetrahedra_only are read from it) from a
// grid made for the same alpha, and appends the stages from kernel I on to its timings. Runs in the
// calling task arena. Throws Cancelled, std::bad_alloc.
DualEdgeStatistics compute_by_dual_edges(const BallSet& balls, const UniformGrid& grid,
                                         const RunContext& context, StageTimer& timer,
                                         AlphaComplex& complex);

}  // namespace alphascope
