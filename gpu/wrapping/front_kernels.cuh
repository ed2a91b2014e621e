// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels of the front: known tetrahedra, their open faces, and the tetrahedra of a round. Only
// wrapping.cu includes kernels.
#pragma once

#include "gpu/wrapping/front.cuh"

namespace alphascope::gpu {

// Writes the quads of known tetrahedra. `vertices`: four ball indices each. `slot`: of each ball.
__global__ void read_quads(const std::uint32_t* vertices, std::uint32_t count,
                           const std::uint32_t* slot, const int4* balls, Quad* quads) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  std::uint32_t s[4];
  for (int c = 0; c < 4; ++c) s[c] = slot[vertices[4 * n + c]];
  const auto order = [&](int a, int b) {
    if (s[a] <= s[b]) return;
    const std::uint32_t kept = s[a];
    s[a] = s[b];
    s[b] = kept;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  const auto lifted = [&](int c) {
    const int4 own = balls[s[0]], other = balls[s[c]];
    return lifted_vector(own, own.w, other, other.w);
  };
  const bool negative = determinant(lifted(1), lifted(2), lifted(3)) < 0;
  quads[n] = make_uint4(s[0] | (negative ? kNegative : 0), s[1], s[2], s[3]);
}

// Joins the faces of the first `count` tetrahedra. Their neighbours must be kOpen before.
__global__ void join_faces(Faces faces, FaceTable table, std::uint32_t count) {
  const std::uint32_t n = grid_thread();
  if (n >= 4 * count) return;
  const FaceBalls f = face_of(faces.quads[n >> 2], static_cast<int>(n & 3));
  const FaceRef other = enter_face(table, faces, f, n, place_of(table, faces, f));
  if (other == kEmptyEntry || other == kNoRoom) return;
  faces.neighbours[n] = other;
  faces.neighbours[other] = n;
}

// Puts the open faces of the first `count` tetrahedra into queue and table, and marks their balls.
__global__ void queue_open_faces(Front front, std::uint32_t count, std::uint32_t* is_needed) {
  const std::uint32_t n = grid_thread();
  if (n >= 4 * count || front.faces.neighbours[n] != kOpen) return;
  const FaceBalls f = face_of(front.faces.quads[n >> 2], static_cast<int>(n & 3));
  is_needed[f.i] = is_needed[f.j] = is_needed[f.k] = 1;
  const std::uint32_t at = atomicAdd(&front.counts->tail, 1u);
  if (at < front.queue_room) {
    front.queue[at] = n;
    if (enter_face(front.table, front.faces, f, n, place_of(front.table, front.faces, f)) ==
        kNoRoom)
      front.counts->full = 1;
  } else {
    front.counts->full = 1;
  }
}

// Notes for each ball of these tetrahedra 1 + the number of one of them.
__global__ void mark_found(const Quad* quads, std::uint32_t count, std::uint32_t* found) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  const Quad q = quads[n];
  found[q.x & ~kNegative] = found[q.y] = found[q.z] = found[q.w] = n + 1;
}

// A ball is needed if it has an open face or no tetrahedron.
__global__ void add_unfound(const std::uint32_t* found, std::uint32_t count,
                            std::uint32_t* is_needed) {
  const std::uint32_t n = grid_thread();
  if (n < count && found[n] == 0) is_needed[n] = 1;
}

__global__ void gather_needed(const int4* balls, const std::uint32_t* is_needed,
                              const std::uint32_t* place, std::uint32_t count, int4* tree_ball,
                              std::uint32_t* tree_slot) {
  const std::uint32_t n = grid_thread();
  if (n >= count || is_needed[n] == 0) return;
  tree_ball[place[n]] = balls[n];
  tree_slot[place[n]] = n;
}

// One thread. Begins the next round.
__global__ void begin_round(FrontCounts* counts) {
  if (grid_thread() != 0) return;
  FrontCounts& c = *counts;
  c.begin = c.end;
  c.end = c.full != 0 ? c.begin : c.tail;
  c.quads_before = c.quads;
  for (int search = 0; search < kSearches; ++search) {
    c.all[search] += c.listed[search];
    c.listed[search] = c.next[search] = 0;
  }
  c.listed[kNear] = c.end - c.begin;
  if (c.begin < c.end) ++c.rounds;
}

// The corners of a tetrahedron other than that of the ball before its face, k = 0, 1, 2.
__device__ inline int other_corner(const QuadAtFace& made, int k) {
  return k + (k >= made.corner ? 1 : 0);
}
// Looks for the other faces of a tetrahedron. Their buckets are on their way together.
__device__ inline void find_others(const Front& front, const QuadAtFace& made, FaceBalls face[3],
                                   FacePlace place[3]) {
  for (int k = 0; k < 3; ++k) face[k] = face_of(made.quad, other_corner(made, k));
  const FaceKey key[3] = {{front.table, face[0]}, {front.table, face[1]}, {front.table, face[2]}};
  const FaceBucket bucket[3] = {
      {front.table, key[0]}, {front.table, key[1]}, {front.table, key[2]}};
  for (int k = 0; k < 3; ++k)
    place[k] = place_of(front.table, front.faces, face[k], key[k], bucket[k]);
}

// Adds the tetrahedra that this round found. Faces of one tetrahedron that were searched in this
// round all found it, unless one claimed it first. The one with the least reference adds it.
__global__ void extend_front(Front front) {
  const FrontCounts& c = *front.counts;
  if (c.full != 0) return;
  const std::uint32_t begin = c.begin, end = c.end, before = c.quads_before;
  const int lane = static_cast<int>(threadIdx.x & 31);
  for (std::uint32_t base = begin + blockIdx.x * blockDim.x; base < end;
       base += gridDim.x * blockDim.x) {
    const std::uint32_t n = base + threadIdx.x;
    const FaceRef own = n < end ? front.queue[n] : 0;
    const std::uint32_t apex = n < end ? front.apex[own] : kUnsearched;
    const unsigned hulls = __ballot_sync(~0u, apex == kHull);
    if (lane == 0 && hulls != 0)
      atomicAdd(&front.counts->hull, static_cast<std::uint32_t>(__popc(hulls)));
    bool adds = is_ball(apex);
    QuadAtFace made{};
    FaceBalls face[3];
    FacePlace place[3];
    if (adds) {
      made = quad_of(face_of(front.faces.quads[own >> 2], static_cast<int>(own & 3)), apex);
      find_others(front, made, face, place);
      std::uint32_t apexes[3];
      for (int k = 0; k < 3; ++k)
        apexes[k] = place[k].entry >> 2 < before ? front.apex[place[k].entry] : kUnsearched;
      for (int k = 0; k < 3; ++k) adds = adds && (own < place[k].entry || !is_ball(apexes[k]));
    }
    const unsigned votes = __ballot_sync(~0u, adds);
    std::uint32_t t = 0;
    if (lane == 0 && votes != 0)
      t = atomicAdd(&front.counts->quads, static_cast<std::uint32_t>(__popc(votes)));
    t = __shfl_sync(~0u, t, 0) + static_cast<std::uint32_t>(__popc(votes & ((1u << lane) - 1)));
    if (adds && t >= front.quad_room) {
      front.counts->full = 1;
      adds = false;
    }
    const auto join = [&](FaceRef ref, FaceRef other) {
      front.faces.neighbours[ref] = other;
      front.faces.neighbours[other] = ref;
    };
    if (adds) {
      front.faces.quads[t] = made.quad;
      __threadfence();
      join(4 * t + static_cast<FaceRef>(made.corner), own);
    }
    unsigned opens[3];  // lanes whose k-th other face is open
    std::uint32_t opened = 0;
    for (int k = 0; k < 3; ++k) {
      bool is_open = false;
      if (adds) {
        const FaceRef ref = 4 * t + static_cast<FaceRef>(other_corner(made, k));
        const FaceRef entry = enter_face(front.table, front.faces, face[k], ref, place[k]);
        is_open = entry == kEmptyEntry;
        if (entry == kNoRoom) {
          front.counts->full = 1;
        } else if (!is_open) {
          join(ref, entry);
        }
      }
      opens[k] = __ballot_sync(~0u, is_open);
      opened += static_cast<std::uint32_t>(__popc(opens[k]));
    }
    std::uint32_t at = 0;
    if (lane == 0 && opened != 0) at = atomicAdd(&front.counts->tail, opened);
    at = __shfl_sync(~0u, at, 0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t own_at =
          at + static_cast<std::uint32_t>(__popc(opens[k] & ((1u << lane) - 1)));
      if ((opens[k] >> lane & 1) != 0 && own_at < front.queue_room)
        front.queue[own_at] = 4 * t + static_cast<FaceRef>(other_corner(made, k));
      at += static_cast<std::uint32_t>(__popc(opens[k]));
    }
    if (lane == 0 && at > front.queue_room) front.counts->full = 1;
  }
}

}  // namespace alphascope::gpu
