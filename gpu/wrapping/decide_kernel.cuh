// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel that compares the candidates of doubtful faces.
#pragma once

#include "gpu/wrapping/face_search.cuh"

namespace alphascope::gpu {

// One thread for each listed face.
__global__ void decide_faces(Front front, const int4* balls, SearchList doubtful,
                             const Candidates* candidates) {
  const std::uint32_t end = *doubtful.count;
  for (std::uint32_t n = grid_thread(); n < end; n += gridDim.x * blockDim.x) {
    const FaceRef ref = doubtful.faces[n];
    const FaceBalls face = face_of(front.faces.quads[ref >> 2], static_cast<int>(ref & 3));
    const int4 i = balls[face.i], j = balls[face.j], k = balls[face.k];
    ExactBest best(lifted_vector(i, i.w, j, j.w), lifted_vector(i, i.w, k, k.w), face.side);
    for (const std::uint32_t slot : candidates[n].slot) {
      if (slot == kHull) break;
      best.add(lifted_vector(i, i.w, balls[slot], balls[slot].w), slot);
    }
    front.apex[ref] = best.slot;
  }
}

}  // namespace alphascope::gpu
