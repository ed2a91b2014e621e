// The facet kernels on the CPU (oneTBB): from balls to K_alpha in the stages of the stage table.
// Choosing between facets and other routes is facet_engine.cpp's business.
#pragma once

#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/uniform_grid.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// How often the filter could not decide, for display.
struct FacetStatistics {
  std::size_t candidate_edges = 0;  // facets looked at
  std::size_t exact_facets = 0;     // of these, done again in exact integers
};

// Mean number of neighbours of a ball and mean of its square, from at most `samples` balls spread
// over the grid: what the cost of the facets depends on.
struct NeighbourMoments {
  double mean = 0, mean_square = 0;
};
NeighbourMoments sample_neighbours(const UniformGrid& grid, std::size_t samples);

// Fills the simplices of `complex` (alpha_on_lattice and tetrahedra_only are read from it) from a
// grid made for the same alpha, and appends the stages from kernel I on to its timings. Runs in the
// calling task arena. Throws Cancelled, std::bad_alloc.
FacetStatistics compute_facets(const BallSet& balls, const UniformGrid& grid,
                               const RunContext& context, StageTimer& timer, AlphaComplex& complex);

}  // namespace alphascope
