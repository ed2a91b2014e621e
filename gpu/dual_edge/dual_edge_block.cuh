// SPDX-License-Identifier: GPL-3.0-or-later
// One block of the dual edge kernels: its problem, shared memory and ordered neighbour lists. Rows
// of bits tell which neighbours meet.
#pragma once

#include <algorithm>

#include "core/dual_edge/facet_disc.hpp"
#include "core/dual_edge/triangle_faces.hpp"
#include "gpu/dual_edge/problem.cuh"

namespace alphascope::gpu {

// Edges from each ball to its later neighbours that may be in K_alpha, ascending.
struct EdgeCandidates {
  std::uint32_t* end;  // the later ball
  // ordered_bits of the least value of a coface in K_alpha; kNoValue: none.
  std::uint32_t* least;
  std::uint32_t* flags;  // kUnattached, and the coface_flags of those cofaces
  std::uint32_t capacity;
  std::uint32_t* cursor;
  std::uint32_t *start, *count;  // for each ball
  std::uint32_t* missing;        // number of failed look-ups
};

// Tetrahedra of K_alpha in the order in which blocks finished.
struct FoundTetrahedra {
  uint4* vertices;
  std::uint32_t capacity;
  std::uint32_t* cursor;         // number found; if it exceeds capacity, the run is repeated
  std::uint32_t *start, *count;  // for each ball as lowest vertex
};

// Triangles of K_alpha in the same order.
struct FoundTriangles {
  std::uint32_t* vertices;  // 3 each
  std::uint32_t* info;      // as pack_info() makes it
  // Last vertex of the tetrahedron that gives the triangle its value; kNoBall: its own value.
  std::uint32_t* attached_to;
  std::uint32_t capacity;
  std::uint32_t* cursor;
  std::uint32_t *start, *count;  // for each ball as lowest vertex
};
inline constexpr std::uint32_t kNoBall = ~0u;

// Packs the places of edges ij and ik among the candidates of i, and the number of cofaces in
// K_alpha.
__device__ inline std::uint32_t pack_info(int edge_j, int edge_k, int cofaces) {
  return static_cast<std::uint32_t>(edge_j) | static_cast<std::uint32_t>(edge_k) << 12 |
         static_cast<std::uint32_t>(cofaces) << 24;
}

struct DualEdgeOutput {
  FoundTetrahedra tetrahedra;
  // Set only for a whole complex:
  FoundTriangles triangles;
  EdgeCandidates edges;
  std::uint32_t* vertex_state;  // for each ball: 0 absent, 1 attached, 2 unattached

  std::uint32_t *exact_list, *exact_count;
  BlockStatistics* statistics;
};

// Kinds of kernels. With kWhole they find all simplices, else tetrahedra alone. With kExact they
// are kernel III, else kernel II. With kCull they leave out neighbours without a facet, which pays
// off for long lists.
template <bool kWhole_, bool kExact_, bool kCull_>
struct KernelKind {
  static constexpr bool kWhole = kWhole_, kExact = kExact_, kCull = kCull_;
  // false: every edge of a ball to a later neighbour counts as possible.
  static constexpr bool kEdges = kWhole || kCull;
};

struct DualEdgeProblem {
  Problem common;
  std::uint32_t begin, end;  // range of balls of this launch
  BlockRoom capacity;
  // If more balls are deferred, kernel III does nothing and the run is repeated with more room.
  std::uint32_t deferred_limit;
  int words;           // length of a row of bits: (capacity.list + 31) / 32
  float radius_scale;  // scale²: factor from square lattice units to scaled ones
  bool small_lattice;  // whether Int128 suffices for exact predicates
  bool cull;           // as KernelKind::kCull
  bool narrow;         // whether 32 bits hold every c of neighbours
  const int4* balls;   // in the order of the BallSet
  // Offsets in words from the start of a block's memory, for the arrays of DualEdgeMemory.
  struct BlockLayout {
    std::uint32_t kept, index, found_bits, one_bits, two_bits, triangles_before, tetrahedra_before,
        possible, near, rows, triangles, half_warp, reach, listed, probed, row_ball;
    std::size_t bytes;
  } layout;
};

constexpr int kMaxRows = 1 << 13, kMaxTriangles = 1 << 16;
__device__ inline bool is_sampled(const DualEdgeProblem& p) {
  return blockIdx.x % p.common.sampled == 0;
}

// Packs a triangle of the block: row of j, neighbour k, ball.
__device__ inline std::uint32_t pack_triangle(int row, int k, int ball) {
  return static_cast<std::uint32_t>(row) | static_cast<std::uint32_t>(k) << 13 |
         static_cast<std::uint32_t>(ball) << 25;
}

struct DualEdgeMemory {
  float4* vectors;  // for each entry scaled d and c; entries ascend by index
  std::uint32_t* index;
  std::uint32_t* rows;  // for each later neighbour j a row of bits: the balls that meet j as well
  uint2* kept;          // for each found triangle its number and pack_face()
  // A row of p.words words for each ball. `possible` marks neighbours j whose edge ij may be in
  // K_alpha. `near` marks neighbours with the nearest planes (for culled lists only).
  std::uint32_t *possible, *near;
  // One bit for each triangle: it is found; it has at least one tetrahedron to write; it has two.
  // The last two arrays hold for each word the number of simplices in the words before.
  std::uint32_t *found_bits, *one_bits, *two_bits, *triangles_before, *tetrahedra_before;
  std::uint32_t* triangles;
  std::uint16_t* listed;  // triangles that are candidates
  std::uint16_t* probed;  // triangles that probe_triangles() kept
  std::uint8_t* length;   // see sort_candidates(); shares memory with kept and probed
  // For each row its ball, and kUnattachedRow.
  std::uint8_t* row_ball;
  // The arrays below share memory with `triangles` and are used before it. `reach` has for each
  // entry how far its ball reaches. The others belong to a half warp: the balls found, and among
  // them the coverers, whose planes are nearest.
  float* reach;
  float4* coverers;
  float* coverer_lengths;
  std::uint32_t *found, *found_index;
};

constexpr int kRowBall = 63, kUnattachedRow = 64;
static_assert(kMaxBallsPerBlock < kRowBall);

// Number of balls tried as coverers of discs: those with the nearest planes.
constexpr int kCoverers = 16;

inline std::uint32_t half_warp_words(const DualEdgeProblem& p) {
  // Capacities of searches are multiples of 4. order_list() needs four more words.
  return 2 * p.capacity.search + 4 + (p.cull ? 5 * kCoverers : 0);
}
inline std::uint32_t half_warps_words(const DualEdgeProblem& p) {
  // Half warps process balls in pairs.
  const int halves = kBlockThreads / kSearchLanes, pairs = (p.common.balls_per_block + 1) / 2;
  return static_cast<std::uint32_t>(std::min(2 * pairs, halves)) * half_warp_words(p);
}
// If the memory needs more bytes than 32 bits can count, only the number of bytes is right.
inline void lay_out(DualEdgeProblem& p) {
  DualEdgeProblem::BlockLayout& at = p.layout;
  std::size_t words = 4 * std::size_t{p.capacity.entries};
  const auto take = [&](std::size_t size) {
    const auto begin = static_cast<std::uint32_t>(words);
    words += size;
    return begin;
  };
  const std::uint32_t bits = (p.capacity.triangles + 31) / 32 + 1,
                      list_bits = static_cast<std::uint32_t>(p.common.balls_per_block * p.words);
  const std::size_t lengths = p.cull ? 0 : (std::size_t{p.capacity.triangles} + 3) / 4;
  at.kept = take(std::max(2 * std::size_t{p.capacity.kept} + (p.capacity.probed + 1) / 2, lengths));
  at.probed = at.kept + 2 * p.capacity.kept;
  at.index = take(p.capacity.entries);
  at.found_bits = take(bits);
  at.one_bits = take(bits);
  at.two_bits = take(bits);
  at.triangles_before = take(bits);
  at.tetrahedra_before = take(bits);
  at.possible = take(list_bits);
  at.near = take(list_bits);
  at.rows = take(p.capacity.rows * static_cast<std::size_t>(p.words));
  words = (words + 3) / 4 * 4;
  at.half_warp = half_warp_words(p);
  const std::uint32_t lists = half_warps_words(p);
  at.triangles =
      take(std::max(std::size_t{p.capacity.triangles}, lists + std::size_t{p.capacity.entries}));
  at.reach = at.triangles + lists;
  at.listed = take((p.capacity.listed + 1) / 2);
  at.row_ball = take((p.capacity.rows + 3) / 4);
  at.bytes = 4 * words;
}
__device__ inline DualEdgeMemory carve(unsigned char* shared, const DualEdgeProblem& p) {
  const DualEdgeProblem::BlockLayout& at = p.layout;
  std::uint32_t* words = reinterpret_cast<std::uint32_t*>(shared);
  DualEdgeMemory m;
  m.vectors = reinterpret_cast<float4*>(shared);
  m.kept = reinterpret_cast<uint2*>(words + at.kept);
  m.reach = reinterpret_cast<float*>(words + at.reach);
  m.index = words + at.index;
  m.found_bits = words + at.found_bits;
  m.one_bits = words + at.one_bits;
  m.two_bits = words + at.two_bits;
  m.triangles_before = words + at.triangles_before;
  m.tetrahedra_before = words + at.tetrahedra_before;
  m.possible = words + at.possible;
  m.near = words + at.near;
  m.rows = words + at.rows;
  m.triangles = words + at.triangles;
  m.listed = reinterpret_cast<std::uint16_t*>(words + at.listed);
  m.probed = reinterpret_cast<std::uint16_t*>(words + at.probed);
  m.length = reinterpret_cast<std::uint8_t*>(words + at.kept);
  m.found = m.triangles + threadIdx.x / kSearchLanes * at.half_warp;
  m.found_index = m.found + p.capacity.search;
  // Only for culled lists.
  m.coverers = reinterpret_cast<float4*>(m.found_index + p.capacity.search + 4);
  m.coverer_lengths = reinterpret_cast<float*>(m.coverers + kCoverers);
  m.row_ball = reinterpret_cast<std::uint8_t*>(words + at.row_ball);
  return m;
}

// Data for each ball of the block.
constexpr int kLengths = 32;  // longer ones count as this long
struct BlockBalls {
  int4 ball[kMaxBallsPerBlock];
  std::uint32_t index[kMaxBallsPerBlock];
  float radius_square[kMaxBallsPerBlock];  // w + alpha, scaled
  int list[kMaxBallsPerBlock];             // number of neighbours; 0 if they found no room
  int later[kMaxBallsPerBlock];            // number of those of higher index
  int entry0[kMaxBallsPerBlock];           // index of the first entry
  int row0[kMaxBallsPerBlock];
  int exact[kMaxBallsPerBlock];  // 1: undecided, 2: no room; both go to kernel III
  int first_triangle[kMaxBallsPerBlock], end_triangle[kMaxBallsPerBlock];
  // Offsets into the output lists, modulo 2^32. The index of a triangle or tetrahedron in the list
  // is the offset plus its number in the block; that of an edge is the offset plus its row.
  std::uint32_t triangle_at[kMaxBallsPerBlock], tetrahedron_at[kMaxBallsPerBlock],
      edge_at[kMaxBallsPerBlock];
  // 0: absent at any alpha; 1: the ball's centre lies outside its power cell (attached); 2: within
  // it.
  std::uint8_t state[kMaxBallsPerBlock];
  int scan[kBlockThreads / 32];
  ReachableBalls reachable[kBlockThreads / kSearchLanes];
  Measured all_found, all_lists;  // as BlockStatistics' found and list
  // For each number of cuts, most cuts first, the number of triangles with as many; later the
  // offset of these triangles in the sorted list.
  int lengths[kLengths];
  int entries, rows, triangles;
  int listed, next_listed, probed, next_work, kept;
};

// The data of a block. Its own balls are [first, first + balls) of the BallSet.
struct Block {
  const DualEdgeProblem& p;
  const DualEdgeOutput& out;
  const DualEdgeMemory& m;
  BlockBalls& s;
  int words;  // length of a row of bits: p.words, as a compile-time constant if possible
  std::uint32_t first;
  int balls;
};

// Sum over the lanes before this one.
__device__ inline int warp_scan(int value) {
  const int lane = threadIdx.x & 31;
  int sum = value;
  for (int step = 1; step < 32; step *= 2) {
    const int other = __shfl_up_sync(~0u, sum, step);
    if (lane >= step) sum += other;
  }
  return sum - value;
}

// Sum over the threads before this one; *total: over all. Every thread must call it.
__device__ inline int block_scan(int value, int* scratch, int* total) {
  const int lane = threadIdx.x & 31, warp = threadIdx.x >> 5;
  const int before = warp_scan(value);
  __syncthreads();  // an earlier scan's scratch must have been read
  if (lane == 31) scratch[warp] = before + value;
  __syncthreads();
  int sum = 0, all = 0;
  for (int w = 0; w < kBlockThreads / 32; ++w) {
    const int part = scratch[w];
    if (w < warp) sum += part;
    all += part;
  }
  *total = all;
  return sum + before;
}

// Reads first, because few blocks find a new maximum.
__device__ inline void note_largest(std::uint32_t* largest, int value) {
  if (*static_cast<volatile std::uint32_t*>(largest) < static_cast<std::uint32_t>(value)) {
    atomicMax(largest, static_cast<std::uint32_t>(value));
  }
}
__device__ inline void add(std::uint64_t* sum, std::uint64_t value) {
  atomicAdd(reinterpret_cast<unsigned long long*>(sum), static_cast<unsigned long long>(value));
}
// Adds a value. Lanes of several warps call it for the block's memory, and one thread of each block
// for all blocks.
__device__ inline void measure(Measured& of, int value) {
  add(&of.number, 1);
  add(&of.sum, value);
  add(&of.squares, static_cast<std::uint64_t>(value) * value);
}
__device__ inline void add_measured(Measured& to, const Measured& of) {
  add(&to.number, of.number);
  add(&to.sum, of.sum);
  add(&to.squares, of.squares);
}

// A triangle of the block with its parts unpacked.
struct Triangle : TriangleRows {
  int ball, entry0;

  // The triangle of this number.
  __device__ Triangle(const Block& block, int number)
      : Triangle(block, block.m.triangles[number]) {}

 private:
  __device__ Triangle(const Block& block, std::uint32_t packed)
      : ball(packed >> 25), entry0(block.s.entry0[ball]) {
    const BlockBalls& s = block.s;
    const int row = packed & (kMaxRows - 1), first_later = s.list[ball] - s.later[ball];
    k = packed >> 13 & 4095;
    j = first_later + row - s.row0[ball];
    row_j = block.m.rows + row * block.words;
    row_k = block.m.rows + (s.row0[ball] + k - first_later) * block.words;
  }
};

// Packs both ends (12 bits, plus 1 so that -1 is 0), and the end to which the triangle attaches.
__device__ inline std::uint32_t pack_face(const TriangleFace& f) {
  return static_cast<std::uint32_t>(f.high + 1) | static_cast<std::uint32_t>(f.low + 1) << 12 |
         static_cast<std::uint32_t>(f.attached) << 24;
}
__device__ inline TriangleFace unpack_face(std::uint32_t packed) {
  return {Decision::in, static_cast<int>(packed & 4095) - 1,
          static_cast<int>(packed >> 12 & 4095) - 1,
          static_cast<TriangleFace::Attached>(packed >> 24)};
}

// The scaled vectors of one ball's neighbours.
struct ScaledNeighbours {
  const float4* vectors;
  __device__ LiftedVector<float> operator()(int a) const {
    const float4 v = vectors[a];
    return {v.x, v.y, v.z, v.w};
  }
};

// The neighbours of a ball for the exact templates, read from the balls themselves.
struct ExactNeighbours {
  const std::uint32_t* indices;
  const int4* balls;
  int4 centre;
  __device__ LiftedInt lifted(int k) const {
    const int4 b = balls[indices[k]];
    return lifted_vector(centre, centre.w, b, b.w);
  }
  __device__ std::int64_t weight() const { return static_cast<std::int64_t>(centre.w) * centre.w; }
  __device__ Neighbourhood<ExactNeighbours> of(const DualEdgeProblem& p) const {
    return {*this, weight(), &p.common.alpha, p.common.ghost_reach, true};
  }
};
__device__ inline ExactNeighbours exact_neighbours(const Block& block, int b) {
  return {block.m.index + block.s.entry0[b], block.p.balls, block.s.ball[b]};
}

}  // namespace alphascope::gpu
