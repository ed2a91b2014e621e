// SPDX-License-Identifier: GPL-3.0-or-later
// The growing part of a triangulation on the device: tetrahedra, their neighbours, and a table of
// faces. Balls are numbered by slots, which follow a curve through space.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/predicates/perturbation.hpp"
#include "gpu/wrapping/ball_tree.cuh"

namespace alphascope::gpu {

// A face of a tetrahedron: four times the tetrahedron's number plus the corner opposite the face.
using FaceRef = std::uint32_t;
inline constexpr FaceRef kOpen = ~0u;        // as a neighbour: none is known
inline constexpr FaceRef kEmptyEntry = ~0u;  // in a table

// The ball before a face, or one of these.
inline constexpr std::uint32_t kUnsearched = ~0u;
inline constexpr std::uint32_t kHull = ~0u - 1;     // there is none
inline constexpr std::uint32_t kClaimed = ~0u - 2;  // another face of the same tetrahedron has it
__device__ inline bool is_ball(std::uint32_t apex) {
  return apex < kClaimed;
}

// Slots a < b < c < d. The top bit of a is set if d lies behind abc: det(b - a, c - a, d - a) < 0.
using Quad = uint4;
inline constexpr std::uint32_t kNegative = 1u << 31;

// The face opposite a corner, i < j < k. The known tetrahedron lies behind it if `side` is 1.
struct FaceBalls {
  std::uint32_t i, j, k;
  int side;
};
__device__ inline FaceBalls face_of(const Quad& q, int corner) {
  const std::uint32_t a = q.x & ~kNegative;
  // The opposite ball is on the side of the sign for corners 3 and 1, and on the other for 2 and 0.
  const int sign = (q.x & kNegative) != 0 ? -1 : 1;
  return {corner == 0 ? q.y : a, corner <= 1 ? q.z : q.y, corner <= 2 ? q.w : q.z,
          (corner & 1) != 0 ? -sign : sign};
}

// The tetrahedron of a face and the ball before it, and the ball's corner.
struct QuadAtFace {
  Quad quad;
  int corner;
};
__device__ inline QuadAtFace quad_of(const FaceBalls& f, std::uint32_t apex) {
  const int corner = (apex > f.i) + (apex > f.j) + (apex > f.k);
  Quad q = make_uint4(f.i, f.j, f.k, apex);
  if (corner == 0) q = make_uint4(apex, f.i, f.j, f.k);
  if (corner == 1) q = make_uint4(f.i, apex, f.j, f.k);
  if (corner == 2) q = make_uint4(f.i, f.j, apex, f.k);
  if ((f.side < 0) == ((corner & 1) != 0)) q.x |= kNegative;
  return {q, corner};
}

struct Faces {
  Quad* quads;
  FaceRef* neighbours;  // four for each tetrahedron
};

// A table of faces with open addressing. Entries are never removed.
struct FaceTable {
  FaceRef* entries;
  std::uint32_t size;
};

__device__ inline std::uint32_t hash_face(const FaceBalls& f) {
  std::uint32_t h = f.i * 0x9e3779b1u ^ f.j * 0x85ebca77u ^ f.k * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 13;
  return h * 0x9e3779b1u;
}
// The entry at which the search for a face begins, and the one after another.
__device__ inline std::uint32_t first_entry(const FaceTable& table, const FaceBalls& f) {
  return static_cast<std::uint32_t>((std::uint64_t{hash_face(f)} * table.size) >> 32);
}
__device__ inline std::uint32_t next_entry(const FaceTable& table, std::uint32_t at) {
  return at + 1 < table.size ? at + 1 : 0;
}
__device__ inline bool is_face(const Faces& faces, FaceRef ref, const FaceBalls& f) {
  const FaceBalls g = face_of(__ldcg(&faces.quads[ref >> 2]), static_cast<int>(ref & 3));
  return g.i == f.i && g.j == f.j && g.k == f.k;
}
// Returns the face's entry, or kEmptyEntry.
__device__ inline FaceRef find_face(const FaceTable& table, const Faces& faces,
                                    const FaceBalls& f) {
  for (std::uint32_t at = first_entry(table, f);; at = next_entry(table, at)) {
    const FaceRef entry = __ldcg(&table.entries[at]);
    if (entry == kEmptyEntry || is_face(faces, entry, f)) return entry;
  }
}
// Enters the face as `own` if it is new, and returns kEmptyEntry. Else returns its entry. The quad
// of `own` must be visible to all threads before.
__device__ inline FaceRef enter_face(const FaceTable& table, const Faces& faces, const FaceBalls& f,
                                     FaceRef own) {
  for (std::uint32_t at = first_entry(table, f);; at = next_entry(table, at)) {
    FaceRef entry = __ldcg(&table.entries[at]);
    if (entry == kEmptyEntry) {
      entry = atomicCAS(&table.entries[at], kEmptyEntry, own);
      if (entry == kEmptyEntry) return kEmptyEntry;
    }
    if (is_face(faces, entry, f)) return entry;
  }
}

// The searches of a face, each for those that the ones before leave over: in a grid; in the
// tree; in the tree by a whole block; among listed candidates by integers; in the tree
// by integers.
enum Search { kNear, kFar, kWide, kDoubtful, kExact, kSearches };

// Numbers of the front. Faces [begin, end) of the queue are searched in this round.
struct FrontCounts {
  std::uint32_t begin, end, tail;     // tail: end of the queue, which the next round searches
  std::uint32_t quads, quads_before;  // all, and those before this round
  std::uint32_t rounds, hull, full;
  std::uint32_t listed[kSearches];  // faces of this round for each search; kNear: unused
  std::uint32_t next[kSearches];    // of those, or of the queue, for the next free lanes
  std::uint32_t all[kSearches];     // faces of all rounds for each search
};

struct Front {
  Faces faces;
  FaceTable table;
  FaceRef* queue;
  std::uint32_t* apex;  // by face
  std::uint32_t quad_room, queue_room;
  FrontCounts* counts;
};

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
  const FaceRef other = enter_face(table, faces, f, n);
  if (other == kEmptyEntry) return;
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
    enter_face(front.table, front.faces, f, n);
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

// Adds the values of lanes to a list in shared or global memory. Every lane of the warp must call
// it.
__device__ inline void append(bool adds, std::uint32_t value, std::uint32_t* list,
                              std::uint32_t room, std::uint32_t* count) {
  const int lane = static_cast<int>(threadIdx.x & 31);
  const unsigned votes = __ballot_sync(~0u, adds);
  std::uint32_t base = 0;
  if (lane == 0 && votes != 0) base = atomicAdd(count, static_cast<std::uint32_t>(__popc(votes)));
  base = __shfl_sync(~0u, base, 0) + static_cast<std::uint32_t>(__popc(votes & ((1u << lane) - 1)));
  if (adds && base < room) list[base] = value;
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
    FaceRef other[4] = {kEmptyEntry, kEmptyEntry, kEmptyEntry, kEmptyEntry};
    if (adds) {
      made = quad_of(face_of(front.faces.quads[own >> 2], static_cast<int>(own & 3)), apex);
      for (int corner = 0; corner < 4; ++corner) {
        if (corner == made.corner || !adds) continue;
        const FaceRef entry = find_face(front.table, front.faces, face_of(made.quad, corner));
        if (entry == kEmptyEntry || entry >> 2 >= before) continue;
        other[corner] = entry;
        adds = own < entry || !is_ball(front.apex[entry]);
      }
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
    if (adds) {
      front.faces.quads[t] = made.quad;
      __threadfence();
    }
    for (int corner = 0; corner < 4; ++corner) {
      const FaceRef ref = 4 * t + static_cast<FaceRef>(corner);
      bool opens = false;
      if (adds) {
        FaceRef entry = corner == made.corner ? own : other[corner];
        if (entry == kEmptyEntry)
          entry = enter_face(front.table, front.faces, face_of(made.quad, corner), ref);
        opens = entry == kEmptyEntry;
        if (!opens) {
          front.faces.neighbours[ref] = entry;
          front.faces.neighbours[entry] = ref;
        }
      }
      append(opens, ref, front.queue, front.queue_room, &front.counts->tail);
    }
    if (front.counts->tail > front.queue_room) front.counts->full = 1;
  }
}

}  // namespace alphascope::gpu
