// SPDX-License-Identifier: GPL-3.0-or-later
// Proves that a ball is hidden: it lies in a tetrahedron of the triangulation, and does not cut off
// the centre of its orthosphere. Without a proof nothing is said about the ball.
#pragma once

#include "core/wrapping/conflict.hpp"
#include "gpu/wrapping/front.cuh"

namespace alphascope::gpu {

// In `found`, of each slot: 0 for a ball that is in no tetrahedron as far as is known, 1 + the
// number of one of its tetrahedra, or this.
inline constexpr std::uint32_t kHiddenBall = ~0u;

__device__ inline LiftedInt lifted_from(const int4& from, const int4& to) {
  return lifted_vector(from, from.w, to, to.w);
}
__device__ inline IndexedBall indexed_ball(const int4* balls, std::uint32_t slot) {
  const int4 b = balls[slot];
  return {b.x, b.y, b.z, b.w, slot};
}

// Is the centre of ball m beyond the face, on the other side than the face's tetrahedron?
__device__ inline bool is_beyond(const FaceBalls& f, const int4* balls, const int4& m) {
  const int4 i = balls[f.i];
  return orientation(lifted_from(i, balls[f.j]), lifted_from(i, balls[f.k]), lifted_from(i, m)) ==
         f.side;
}

// The ball at a corner.
__device__ inline std::uint32_t ball_at(const Quad& q, int corner) {
  return corner == 0 ? q.x & ~kNegative : corner == 1 ? q.y : corner == 2 ? q.z : q.w;
}

// Slots of balls with the same centre are in the order of their indices.
__device__ inline bool stays_out(const Quad& q, const int4* balls, std::uint32_t slot) {
  const IndexedBall corners[4] = {indexed_ball(balls, ball_at(q, 0)), indexed_ball(balls, q.y),
                                  indexed_ball(balls, q.z), indexed_ball(balls, q.w)};
  return stays_out(corners, indexed_ball(balls, slot));
}

inline constexpr std::uint32_t kNoQuad = ~0u;

// Walks from a tetrahedron to the one around a centre, across any face that the centre is beyond.
// In a regular triangulation the walk visits no tetrahedron twice. Returns kNoQuad if it comes to
// an open face, or takes more than `steps` steps.
__device__ inline std::uint32_t quad_around(const Faces& faces, std::uint32_t count,
                                            const int4* balls, std::uint32_t from, const int4& m,
                                            std::uint32_t steps) {
  std::uint32_t at = from;
  int entry = -1;  // the corner opposite the face through which the walk came
  for (std::uint32_t step = 0; step <= steps; ++step) {
    const Quad q = faces.quads[at];
    int out = -1;
    for (int corner = 0; corner < 4 && out < 0; ++corner) {
      if (corner != entry && is_beyond(face_of(q, corner), balls, m)) out = corner;
    }
    if (out < 0) return at;
    const FaceRef next = faces.neighbours[std::size_t{4} * at + static_cast<unsigned>(out)];
    if (next == kOpen || next >> 2 >= count) return kNoQuad;
    at = next >> 2;
    entry = static_cast<int>(next & 3);
  }
  return kNoQuad;
}

}  // namespace alphascope::gpu
