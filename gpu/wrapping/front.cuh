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

}  // namespace alphascope::gpu
