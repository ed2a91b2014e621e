// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a triangulation on the device: its faces are in pairs and locally regular, its
// tetrahedra are not flat, and each other ball is hidden. core/wrapping/hull_proof.hpp has the
// rest, and says why all of it suffices.
#pragma once

#include "core/wrapping/crossing.hpp"
#include "gpu/wrapping/face_search.cuh"
#include "gpu/wrapping/hidden.cuh"

namespace alphascope::gpu {

// Numbers of faults, and of faces for other checks.
struct CertificateCounts {
  std::uint32_t cells;      // tetrahedra that are flat, or whose sign or order is wrong
  std::uint32_t pairs;      // faces whose neighbour is wrong
  std::uint32_t irregular;  // faces beyond which a ball is in conflict
  std::uint32_t unproven;   // balls that are neither in a tetrahedron nor proven hidden
  std::uint32_t hull;       // faces without a neighbour
  std::uint32_t doubtful;   // faces that floats do not decide
};

struct Certificate {
  Faces faces;
  std::uint32_t count;  // tetrahedra
  const int4* balls;    // by slot
  std::uint32_t slots;
  float scale;        // the tree's
  FaceRef* doubtful;  // has room for every face
  CertificateCounts* counts;
};

__global__ void check_cells(Certificate in) {
  const std::uint32_t n = grid_thread();
  if (n >= in.count) return;
  const Quad q = in.faces.quads[n];
  const std::uint32_t a = q.x & ~kNegative;
  bool good = a < q.y && q.y < q.z && q.z < q.w && q.w < in.slots;
  if (good) {
    const int4 i = in.balls[a];
    const int sign = orientation(lifted_from(i, in.balls[q.y]), lifted_from(i, in.balls[q.z]),
                                 lifted_from(i, in.balls[q.w]));
    good = sign == ((q.x & kNegative) != 0 ? -1 : 1);
  }
  if (!good) atomicAdd(&in.counts->cells, 1u);
}

// Does the ball before the face certainly touch the sphere of the face after the ball behind it
// does? Then the face is locally regular.
__device__ inline bool is_regular_by_floats(const Certificate& in, const FaceBalls& f,
                                            std::uint32_t behind, std::uint32_t before) {
  const int4 i = in.balls[f.i], j = in.balls[f.j], k = in.balls[f.k];
  const LiftedInt vj = lifted_from(i, j), vk = lifted_from(i, k);
  OpenFace<float> face;
  if (!is_exact<float>(vj) || !is_exact<float>(vk) ||
      !face.set(scaled_lifted(vj, in.scale), scaled_lifted(vk, in.scale), f.side))
    return false;
  const auto rough = [&](std::uint32_t slot) {
    const int4 b = in.balls[slot];
    const float weights =
        static_cast<float>(i.w - b.w) * in.scale * (static_cast<float>(i.w + b.w) * in.scale);
    return rough_lifted(static_cast<float>(b.x - i.x) * in.scale,
                        static_cast<float>(b.y - i.y) * in.scale,
                        static_cast<float>(b.z - i.z) * in.scale, weights);
  };
  const Crossing<float> later = face.crossing(rough(before));
  // Seen from the other side, the sphere grows towards the ball behind: its t has the other sign.
  const Crossing<float> earlier = face.turned().crossing(rough(behind));
  return later.low < Crossing<float>::kNever && earlier.low < Crossing<float>::kNever &&
         -earlier.low < later.low;
}

// One thread for each face of each tetrahedron. check_cells() must have found no fault.
__global__ void check_faces(Certificate in) {
  const std::uint32_t n = grid_thread();
  const bool has = n < 4 * in.count;
  bool outside = false, wrong = false, unsure = false;
  if (has) {
    const FaceRef other = in.faces.neighbours[n];
    outside = other == kOpen;
    if (!outside) {
      wrong = other >= 4 * in.count || other >> 2 == n >> 2 || in.faces.neighbours[other] != n;
      if (!wrong) {
        const Quad own = in.faces.quads[n >> 2], across = in.faces.quads[other >> 2];
        const int corner = static_cast<int>(n & 3), beyond = static_cast<int>(other & 3);
        const FaceBalls f = face_of(own, corner), g = face_of(across, beyond);
        wrong = f.i != g.i || f.j != g.j || f.k != g.k || f.side != -g.side;
        // Each face is checked once.
        if (!wrong && n < other)
          unsure = !is_regular_by_floats(in, f, ball_at(own, corner), ball_at(across, beyond));
      }
    }
  }
  if (wrong) atomicAdd(&in.counts->pairs, 1u);
  const unsigned hull = __ballot_sync(~0u, outside);
  if (hull != 0 && (threadIdx.x & 31) == 0)
    atomicAdd(&in.counts->hull, static_cast<std::uint32_t>(__popc(hull)));
  append(unsure, n, in.doubtful, ~0u, &in.counts->doubtful);
}

__global__ void check_doubtful_faces(Certificate in) {
  const std::uint32_t end = in.counts->doubtful;
  for (std::uint32_t n = grid_thread(); n < end; n += gridDim.x * blockDim.x) {
    const FaceRef own = in.doubtful[n], other = in.faces.neighbours[own];
    const std::uint32_t ball = ball_at(in.faces.quads[other >> 2], static_cast<int>(other & 3));
    if (!stays_out(in.faces.quads[own >> 2], in.balls, ball)) atomicAdd(&in.counts->irregular, 1u);
  }
}

__global__ void count_unproven(const std::uint32_t* found, std::uint32_t slots,
                               CertificateCounts* counts) {
  const std::uint32_t n = grid_thread();
  if (n < slots && found[n] == 0) atomicAdd(&counts->unproven, 1u);
}

}  // namespace alphascope::gpu
