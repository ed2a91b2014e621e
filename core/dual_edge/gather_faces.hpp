// SPDX-License-Identifier: GPL-3.0-or-later
// Completes edges and vertices from their cofaces: the least alpha value of the cofaces they are
// attached to, their class, and whether they are in K_alpha at all. This is for the CPU;
// gpu/dual_edge/gather_kernels.cuh is for the GPU.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/dual_edge/ball_simplices.hpp"

namespace alphascope {

// The edges of one ball (as lowest vertex) in the output of its block: indices begin to end - 1.
struct EdgeRange {
  SimplexBuffer<2>* edges = nullptr;
  std::uint32_t begin = 0, end = 0;
};

// Fills the edges of `complex` from its triangles and from the blocks' edges; `ranges` is per ball.
// The first two edges of a triangle know its alpha value and class already (BlockOutput). The third
// edge, jk, is among the edges of ball j. Runs in the calling task arena. Throws InternalError when
// that edge is missing.
void gather_edges(const std::vector<EdgeRange>& ranges, AlphaComplex& complex);

// Fills the vertices from the edges; `states` is per ball.
void gather_vertices(const BallSet& balls, const std::vector<VertexState>& states,
                     AlphaComplex& complex);

}  // namespace alphascope
