// What edges and vertices learn from their cofaces: the least alpha value of those they are
// attached to, their class, and whether they are in K_alpha at all. CPU; the GPU's is
// gpu/dual_edge/gather_kernels.cuh.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/dual_edge/ball_simplices.hpp"

namespace alphascope {

// Where the edges of one ball (as lowest vertex) are in its block's output.
struct EdgeRange {
  SimplexBuffer<2>* edges = nullptr;
  std::uint32_t begin = 0, end = 0;
};

// Fills the edges of `complex` from its triangles and the blocks' edges; `ranges` is per ball. What
// the first two edges of a triangle learn from it is known already (BlockOutput): this is about the
// third, which is another ball's. Runs in the calling task arena. Throws InternalError when it is
// not there.
void gather_edges(const std::vector<EdgeRange>& ranges, AlphaComplex& complex);

// Fills the vertices from the edges; `states` is per ball.
void gather_vertices(const BallSet& balls, const std::vector<VertexState>& states,
                     AlphaComplex& complex);

}  // namespace alphascope
