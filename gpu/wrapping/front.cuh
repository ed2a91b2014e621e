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
inline constexpr FaceRef kEmptyEntry = ~0u;  // in a table: none

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

// A table of faces with open addressing. Entries are never removed. Four of them make a bucket,
// which is read at once, and its first entries are used first. An entry has a face below bits of
// its hash, so that other faces are rarely looked at.
using FaceEntry = unsigned long long;
inline constexpr FaceEntry kNoEntry = ~FaceEntry{0};
inline constexpr int kBucket = 4;
struct FaceTable {
  FaceEntry* entries;
  std::uint32_t buckets;
};
// Too many full buckets follow each other. The table is far too small then.
inline constexpr FaceRef kNoRoom = ~0u - 1;
inline constexpr int kMostProbes = 1024;

// Where the search for a face begins, and the bits that its entry has.
struct FaceKey {
  std::uint32_t bucket, bits;

  __device__ FaceKey(const FaceTable& table, const FaceBalls& f) {
    std::uint64_t h =
        f.i * 0x9e3779b97f4a7c15ull + f.j * 0xc2b2ae3d27d4eb4full + f.k * 0x165667b19e3779f9ull;
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93ull;
    h ^= h >> 32;
    bits = static_cast<std::uint32_t>(h);
    bucket = static_cast<std::uint32_t>(((h >> 32) * table.buckets) >> 32);
  }
  __device__ void next(const FaceTable& table) {
    bucket = bucket + 1 < table.buckets ? bucket + 1 : 0;
  }
  __device__ bool matches(FaceEntry entry) const { return entry >> 32 == bits; }
};
struct FaceBucket {
  FaceEntry entry[kBucket];

  __device__ FaceBucket(const FaceTable& table, const FaceKey& key) {
    const auto* from =
        reinterpret_cast<const uint4*>(table.entries + std::size_t{kBucket} * key.bucket);
    for (int half = 0; half < 2; ++half) {
      const uint4 two = __ldcg(&from[half]);
      entry[2 * half] = FaceEntry{two.y} << 32 | two.x;
      entry[2 * half + 1] = FaceEntry{two.w} << 32 | two.z;
    }
  }
};
__device__ inline bool is_face(const Faces& faces, FaceRef ref, const FaceBalls& f) {
  const FaceBalls g = face_of(__ldcg(&faces.quads[ref >> 2]), static_cast<int>(ref & 3));
  return g.i == f.i && g.j == f.j && g.k == f.k;
}
// Where a face is in the table: its entry, or kEmptyEntry and the place at which it may be entered,
// or kNoRoom.
struct FacePlace {
  FaceRef entry;
  std::uint32_t empty;
};
// Goes on from the bucket of `key`, which is loaded.
__device__ inline FacePlace place_of(const FaceTable& table, const Faces& faces, const FaceBalls& f,
                                     FaceKey key, FaceBucket bucket) {
  for (int probe = 0; probe < kMostProbes; ++probe) {
    for (int n = 0; n < kBucket; ++n) {
      const FaceEntry entry = bucket.entry[n];
      if (entry == kNoEntry) return {kEmptyEntry, kBucket * key.bucket + n};
      const auto ref = static_cast<FaceRef>(entry);
      if (key.matches(entry) && is_face(faces, ref, f)) return {ref, 0};
    }
    key.next(table);
    bucket = FaceBucket(table, key);
  }
  return {kNoRoom, 0};
}
__device__ inline FacePlace place_of(const FaceTable& table, const Faces& faces,
                                     const FaceBalls& f) {
  const FaceKey key(table, f);
  return place_of(table, faces, f, key, FaceBucket(table, key));
}
// Enters the face as `own` if it is new, and returns kEmptyEntry. Else returns its entry, or
// kNoRoom. The quad of `own` must be visible to all threads before. `at`: where the face was a
// moment ago.
__device__ inline FaceRef enter_face(const FaceTable& table, const Faces& faces, const FaceBalls& f,
                                     FaceRef own, FacePlace at) {
  const FaceKey key(table, f);
  while (at.entry == kEmptyEntry) {
    const FaceEntry entry =
        atomicCAS(&table.entries[at.empty], kNoEntry, FaceEntry{key.bits} << 32 | own);
    if (entry == kNoEntry) return kEmptyEntry;
    at = place_of(table, faces, f);
  }
  return at.entry;
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
