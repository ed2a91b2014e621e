// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels that mark vertices and hidden balls.
#pragma once

#include "gpu/wrapping/hidden.cuh"

namespace alphascope::gpu {

// Leaves only the marks of hidden balls. A mark is a proof by a tetrahedron that is still there.
__global__ void keep_hidden(std::uint32_t* found, std::uint32_t slots) {
  const std::uint32_t n = grid_thread();
  if (n < slots && found[n] != kHiddenBall) found[n] = 0;
}

// Marks the balls that are proven hidden by the first `count` tetrahedra. `reach`: how many slots
// on each side are searched for a ball that is found, where the walk begins.
__global__ void mark_hidden(Faces faces, std::uint32_t count, const int4* balls,
                            std::uint32_t slots, std::uint32_t* found, std::uint32_t reach,
                            std::uint32_t steps) {
  const std::uint32_t slot = grid_thread();
  if (slot >= slots || found[slot] != 0) return;
  std::uint32_t from = kNoQuad;
  const auto try_slot = [&](std::uint32_t other) {
    const std::uint32_t at = found[other];
    if (at != 0 && at != kHiddenBall) from = at - 1;
  };
  for (std::uint32_t away = 1; away <= reach && from == kNoQuad; ++away) {
    if (away <= slot) try_slot(slot - away);
    if (from == kNoQuad && slots - slot > away) try_slot(slot + away);
    if (away > slot && slots - slot <= away) break;
  }
  if (from == kNoQuad) return;
  const std::uint32_t at = quad_around(faces, count, balls, from, balls[slot], steps);
  if (at != kNoQuad && stays_out(faces.quads[at], balls, slot)) found[slot] = kHiddenBall;
}

}  // namespace alphascope::gpu
