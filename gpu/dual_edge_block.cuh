// One block of the dual edge kernels: its problem and shared memory, the ordered lists of its
// balls' neighbours, and the rows of bits that say which of them meet.
#pragma once

#include "core/complex/facet_disc.hpp"
#include "core/complex/triangle_tetrahedra.hpp"
#include "gpu/problem.cuh"

namespace alphascope::gpu {

struct DualEdgeOutput {
  uint4* tetrahedra;
  std::uint32_t capacity;
  std::uint32_t* cursor;
  std::uint32_t *start, *count;  // per ball
  std::uint32_t *exact_list, *exact_count;
  BlockStatistics* statistics;
};

struct DualEdgeProblem {
  Problem common;
  BlockRoom capacity;
  std::uint32_t
      deferred_limit;  // beyond so many kernel III leaves the run to be repeated with more room
  int words;           // of a row of bits: (capacity.list + 31) / 32
  float radius_scale;  // scale²: square lattice units to scaled ones
  bool small_lattice;  // Int128 suffices for exact predicates
  int first_cuts;      // of a triangle's cuts, before it is looked at as a survivor
  bool cull_facets;    // long lists: drop edges ij whose disc a single ball covers
  const int4* balls;   // in the order of the BallSet
};

constexpr int kMaxRows = 1 << 13, kMaxTriangles = 1 << 16;
constexpr int kSampled = 64;  // every so many blocks count for the statistics

// Packs a triangle of the block: row of j, neighbour k, ball.
__device__ inline std::uint32_t pack_triangle(int row, int k, int ball) {
  return static_cast<std::uint32_t>(row) | static_cast<std::uint32_t>(k) << 13 |
         static_cast<std::uint32_t>(ball) << 25;
}

struct DualEdgeMemory {
  float4* vectors;  // entries: scaled d and c, ascending by index
  float* reach;
  std::uint32_t* index;
  std::uint32_t* rows;  // words of bits for each later neighbour j: who meets j as well
  uint2* kept;          // triangle, and 12 bits for each of its tetrahedra's last vertices + 1
  std::uint32_t* triangles;
  std::uint16_t* work;     // triangles in order of work
  std::uint8_t* row_ball;  // whose row it is
  // Before the lists are ordered, in the place of triangles and work: what half a warp found.
  std::uint32_t *found, *found_index;
};

constexpr std::size_t kHalves = kBlockThreads / kSearchLanes;

__host__ __device__ inline std::size_t triangle_words(const DualEdgeProblem& p) {
  const std::size_t triangles = (3 * static_cast<std::size_t>(p.capacity.triangles) + 1) / 2;
  const std::size_t lists = 2 * kHalves * p.capacity.list;
  return triangles > lists ? triangles : lists;
}
__host__ __device__ inline std::size_t block_memory_bytes(const DualEdgeProblem& p) {
  return static_cast<std::size_t>(p.capacity.entries) * 24 +
         static_cast<std::size_t>(p.capacity.kept) * 8 +
         static_cast<std::size_t>(p.capacity.rows) * (4 * p.words + 1) + triangle_words(p) * 4 + 16;
}
__device__ inline DualEdgeMemory carve(unsigned char* shared, const DualEdgeProblem& p) {
  DualEdgeMemory m;
  m.vectors = reinterpret_cast<float4*>(shared);
  m.kept = reinterpret_cast<uint2*>(m.vectors + p.capacity.entries);
  m.reach = reinterpret_cast<float*>(m.kept + p.capacity.kept);
  m.index = reinterpret_cast<std::uint32_t*>(m.reach + p.capacity.entries);
  m.rows = m.index + p.capacity.entries;
  m.triangles = m.rows + static_cast<std::size_t>(p.capacity.rows) * p.words;
  m.work = reinterpret_cast<std::uint16_t*>(m.triangles + p.capacity.triangles);
  m.found = m.triangles + threadIdx.x / kSearchLanes * 2 * p.capacity.list;
  m.found_index = m.found + p.capacity.list;
  m.row_ball = reinterpret_cast<std::uint8_t*>(m.triangles + triangle_words(p));
  return m;
}

// Per ball of the block.
constexpr int kLengths = 32;  // longer ones count as this long
struct BlockBalls {
  int4 ball[kMaxBallsPerBlock];
  std::uint32_t index[kMaxBallsPerBlock];
  float radius_square[kMaxBallsPerBlock];  // w + alpha, scaled
  int list[kMaxBallsPerBlock];             // neighbours; none when there is no room for them
  int later[kMaxBallsPerBlock];            // of them, of higher index
  int entry0[kMaxBallsPerBlock];           // where they begin
  int row0[kMaxBallsPerBlock];
  int tetrahedra[kMaxBallsPerBlock];
  int exact[kMaxBallsPerBlock];  // 1 undecided, 2 no room: for kernel III
  int scan[kBlockThreads / 32];
  Surroundings surroundings[kBlockThreads / kSearchLanes];
  int lengths[kLengths];  // triangles of so many cuts; then where they begin
  int entries, rows, triangles;
  int next_triangle, next_work, survivors, kept;
  std::uint32_t base;
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

// Sum over the threads before this one, and over all. Every thread takes part.
__device__ inline int block_scan(int value, int* scratch, int* total) {
  const int lane = threadIdx.x & 31, warp = threadIdx.x >> 5;
  const int before = warp_scan(value);
  __syncthreads();  // an earlier scan's scratch has been read
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

// Few blocks meet a new maximum.
__device__ inline void note_largest(std::uint32_t* largest, int value) {
  if (*static_cast<volatile std::uint32_t*>(largest) < static_cast<std::uint32_t>(value)) {
    atomicMax(largest, static_cast<std::uint32_t>(value));
  }
}
__device__ inline void add(std::uint64_t* sum, std::uint64_t value) {
  atomicAdd(reinterpret_cast<unsigned long long*>(sum), static_cast<unsigned long long>(value));
}

// Writes one ball's list ordered by index, relative to the ball. Half a warp.
__device__ inline void order_list(const Problem& p, const SortedBalls& sorted,
                                  const DualEdgeMemory& m, const int4& centre, int n, int entry0) {
  const std::int64_t wi = static_cast<std::int64_t>(centre.w) * centre.w;
  for (int a = threadIdx.x & (kSearchLanes - 1); a < n; a += kSearchLanes) {
    const std::uint32_t t = m.found[a], index = m.found_index[a];
    const int4 q = sorted.ball[t];
    const float reach = sorted.near[t].w * p.scale;
    int rank = 0;
    for (int o = 0; o < n; ++o) rank += m.found_index[o] < index;
    const std::int64_t x = q.x - centre.x, y = q.y - centre.y, z = q.z - centre.z;
    const std::int64_t c = x * x + y * y + z * z + wi - static_cast<std::int64_t>(q.w) * q.w;
    const int entry = entry0 + rank;
    m.vectors[entry] =
        make_float4(static_cast<float>(x) * p.scale, static_cast<float>(y) * p.scale,
                    static_cast<float>(z) * p.scale, static_cast<float>(c) * p.scale * p.scale);
    m.reach[entry] = reach;
    m.index[entry] = index;
  }
}

// Writes the row of the neighbours that meet j as well as i.
__device__ inline void fill_row(const DualEdgeProblem& p, const DualEdgeMemory& m, int words,
                                int entry0, int n, int j, float radius_square, std::uint32_t* row) {
  const float4 vj = m.vectors[entry0 + j];
  const float reach = m.reach[entry0 + j];
  for (int w = 0; w < words; ++w) {
    std::uint32_t bits = 0;
    const int end = min(n, w * 32 + 32);
    for (int k = w * 32; k < end; ++k) {
      const float4 v = m.vectors[entry0 + k];
      const float x = v.x - vj.x, y = v.y - vj.y, z = v.z - vj.z, sum = m.reach[entry0 + k] + reach;
      if (fmaf(x, x, fmaf(y, y, z * z)) <= sum * sum) bits |= 1u << (k & 31);
    }
    if (j >> 5 == w) bits &= ~(1u << (j & 31));
    row[w] = bits;
  }
  if (!p.cull_facets) return;
  const FacetDisc<float> disc({vj.x, vj.y, vj.z, vj.w}, radius_square);
  bool dead = disc.certainly_empty();
  for (int w = 0; w < words && !dead; ++w) {
    for (std::uint32_t bits = row[w]; bits != 0 && !dead; bits &= bits - 1) {
      const float4 v = m.vectors[entry0 + w * 32 + __ffs(static_cast<int>(bits)) - 1];
      dead = disc.certainly_covered_by({v.x, v.y, v.z, v.w});
    }
  }
  // Without a row, j is in no triangle; it still cuts those of others.
  for (int w = 0; w < words && dead; ++w) row[w] = 0;
}

// A triangle's parts, unpacked.
struct Triangle : TriangleRows {
  int ball, entry0;

  __device__ Triangle(const DualEdgeMemory& m, const BlockBalls& s, int words, std::uint32_t packed)
      : ball(packed >> 25), entry0(s.entry0[ball]) {
    const int row = packed & (kMaxRows - 1), first_later = s.list[ball] - s.later[ball];
    k = packed >> 13 & 4095;
    j = first_later + row - s.row0[ball];
    row_j = m.rows + row * words;
    row_k = m.rows + (s.row0[ball] + k - first_later) * words;
  }
};

}  // namespace alphascope::gpu
