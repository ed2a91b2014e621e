// One block of the dual edge kernels: its problem and shared memory, the ordered lists of its
// balls' neighbours, and the rows of bits that say which of them meet.
#pragma once

#include "core/complex/facet_disc.hpp"
#include "core/complex/triangle_faces.hpp"
#include "gpu/problem.cuh"

namespace alphascope::gpu {

// The edges that may be in K_alpha, of each ball to its later neighbours, ascending.
struct EdgeCandidates {
  std::uint32_t *begin, *end;  // the balls
  // ordered_bits of the least value of a coface in K_alpha, kNoValue for none.
  std::uint32_t* least;
  std::uint32_t* flags;  // kUnattached, and what those cofaces say
  std::uint32_t capacity;
  std::uint32_t* cursor;
  std::uint32_t *start, *count;  // per ball
};

// Tetrahedra of K_alpha in the order in which blocks finished.
struct FoundTetrahedra {
  uint4* vertices;
  std::uint32_t capacity;
  std::uint32_t* cursor;         // found (may pass capacity: then nothing counts)
  std::uint32_t *start, *count;  // per ball, as lowest vertex
};

// The same of triangles.
struct FoundTriangles {
  std::uint32_t* vertices;  // 3 each
  std::uint32_t* info;      // pack_info
  std::uint32_t*
      attached_to;  // the last vertex of the tetrahedron with its value; kNoBall: its own
  std::uint32_t capacity;
  std::uint32_t* cursor;
  std::uint32_t *start, *count;  // per ball
};
inline constexpr std::uint32_t kNoBall = ~0u;

// The places of edges ij and ik among the candidates of i, and the number of tetrahedra in K_alpha.
__device__ inline std::uint32_t pack_info(int edge_j, int edge_k, int cofaces) {
  return static_cast<std::uint32_t>(edge_j) | static_cast<std::uint32_t>(edge_k) << 12 |
         static_cast<std::uint32_t>(cofaces) << 24;
}

struct DualEdgeOutput {
  FoundTetrahedra tetrahedra;
  // Of a whole complex only:
  FoundTriangles triangles;
  EdgeCandidates edges;
  std::uint32_t* vertex_state;  // per ball: 0 absent, 1 attached, 2 unattached

  std::uint32_t *exact_list, *exact_count;
  BlockStatistics* statistics;
};

// What a kernel does: all simplices, or tetrahedra alone; kernel III, or kernel II; are neighbours
// without a facet left out (of long lists it pays)?
template <bool kWhole_, bool kExact_, bool kCull_>
struct KernelKind {
  static constexpr bool kWhole = kWhole_, kExact = kExact_, kCull = kCull_;
  // Without, every edge of a ball to a later one counts as possible.
  static constexpr bool kEdges = kWhole || kCull;
};

struct DualEdgeProblem {
  Problem common;
  BlockRoom capacity;
  std::uint32_t
      deferred_limit;  // beyond so many kernel III leaves the run to be repeated with more room
  int words;           // of a row of bits: (capacity.list + 31) / 32
  float radius_scale;  // scale²: square lattice units to scaled ones
  bool small_lattice;  // Int128 suffices for exact predicates
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
  uint2* kept;          // triangles found: their number, and pack_face()
  // p.words of bits for each ball: which neighbours j can have edge ij in K_alpha, and whose planes
  // are nearest (culled lists only).
  std::uint32_t *possible, *near;
  // One bit a triangle: found; with one tetrahedron to write or more; with two. Then, for each
  // word, what is found in the words before.
  std::uint32_t *found_bits, *one_bits, *two_bits, *triangles_before, *tetrahedra_before;
  std::uint32_t* triangles;
  std::uint16_t* work;  // triangles in order of work
  // Whose row it is, and kUnattachedRow.
  std::uint8_t* row_ball;
  // Before the lists are ordered, in the place of triangles and work: what half a warp met, and of
  // that, those whose planes are nearest.
  float4* coverers;
  float* coverer_lengths;
  std::uint32_t *found, *found_index;
};

constexpr int kRowBall = 63, kUnattachedRow = 64;
static_assert(kMaxBallsPerBlock < kRowBall);

// Balls that are tried as coverers of discs: those whose planes are nearest.
constexpr int kCoverers = 16;

__host__ __device__ inline std::size_t half_warp_words(const DualEdgeProblem& p) {
  // Capacities of a search are multiples of 4. Four more: see order_list().
  return 2 * static_cast<std::size_t>(p.capacity.search) + 4 + 5 * kCoverers;
}
__host__ __device__ inline std::size_t triangle_words(const DualEdgeProblem& p) {
  const std::size_t triangles = (3 * static_cast<std::size_t>(p.capacity.triangles) + 1) / 2;
  // Half warps take balls in pairs.
  const int halves = kBlockThreads / kSearchLanes, pairs = (p.common.balls_per_block + 1) / 2;
  const std::size_t lists = (2 * pairs < halves ? 2 * pairs : halves) * half_warp_words(p);
  return triangles > lists ? triangles : lists;
}
__host__ __device__ inline std::size_t bit_words(const DualEdgeProblem& p) {
  return (static_cast<std::size_t>(p.capacity.triangles) + 31) / 32 + 1;
}
__host__ __device__ inline std::size_t block_memory_bytes(const DualEdgeProblem& p) {
  return static_cast<std::size_t>(p.capacity.entries) * 24 +
         static_cast<std::size_t>(p.capacity.kept) * 8 + bit_words(p) * 20 +
         static_cast<std::size_t>(p.common.balls_per_block) * p.words * 8 +
         static_cast<std::size_t>(p.capacity.rows) * (4 * p.words + 1) + triangle_words(p) * 4 + 32;
}
__device__ inline DualEdgeMemory carve(unsigned char* shared, const DualEdgeProblem& p) {
  DualEdgeMemory m;
  const std::size_t bits = bit_words(p);
  m.vectors = reinterpret_cast<float4*>(shared);
  m.kept = reinterpret_cast<uint2*>(m.vectors + p.capacity.entries);
  m.reach = reinterpret_cast<float*>(m.kept + p.capacity.kept);
  m.index = reinterpret_cast<std::uint32_t*>(m.reach + p.capacity.entries);
  m.found_bits = m.index + p.capacity.entries;
  m.one_bits = m.found_bits + bits;
  m.two_bits = m.one_bits + bits;
  m.triangles_before = m.two_bits + bits;
  m.tetrahedra_before = m.triangles_before + bits;
  m.possible = m.tetrahedra_before + bits;
  m.near = m.possible + static_cast<std::size_t>(p.common.balls_per_block) * p.words;
  m.rows = m.near + static_cast<std::size_t>(p.common.balls_per_block) * p.words;
  const std::size_t rows_end = m.rows - reinterpret_cast<std::uint32_t*>(shared) +
                               static_cast<std::size_t>(p.capacity.rows) * p.words;
  m.triangles = reinterpret_cast<std::uint32_t*>(shared) + (rows_end + 3) / 4 * 4;
  m.work = reinterpret_cast<std::uint16_t*>(m.triangles + p.capacity.triangles);
  std::uint32_t* half = m.triangles + threadIdx.x / kSearchLanes * half_warp_words(p);
  m.coverers = reinterpret_cast<float4*>(half);
  m.coverer_lengths = reinterpret_cast<float*>(half + 4 * kCoverers);
  m.found = half + 5 * kCoverers;
  m.found_index = m.found + p.capacity.search;
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
  int exact[kMaxBallsPerBlock];  // 1 undecided, 2 no room: for kernel III
  int first_triangle[kMaxBallsPerBlock], end_triangle[kMaxBallsPerBlock];
  // Where simplices go, less their number in the block: of triangles and tetrahedra, less the row
  // for edges. Modulo 2^32.
  std::uint32_t triangle_at[kMaxBallsPerBlock], tetrahedron_at[kMaxBallsPerBlock],
      edge_at[kMaxBallsPerBlock];
  bool attached[kMaxBallsPerBlock];  // the ball's centre lies outside its power cell
  int scan[kBlockThreads / 32];
  Surroundings surroundings[kBlockThreads / kSearchLanes];
  int lengths[kLengths];  // triangles of so many cuts; then where they begin
  int entries, rows, triangles;
  int next_triangle, next_work, survivors, kept;
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

// Two ends of 12 bits + 1, and which of them the triangle is attached to.
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

// The neighbours of a ball for the exact templates, straight from the balls.
struct ExactNeighbours {
  const std::uint32_t* indices;
  const int4* balls;
  int4 centre;
  __device__ LiftedInt lifted(int k) const {
    const int4 b = balls[indices[k]];
    const std::int64_t x = b.x - centre.x, y = b.y - centre.y, z = b.z - centre.z;
    const std::int64_t w = static_cast<std::int64_t>(b.w) * b.w,
                       wi = static_cast<std::int64_t>(centre.w) * centre.w;
    return {x, y, z, x * x + y * y + z * z + wi - w};
  }
  __device__ std::int64_t weight() const { return static_cast<std::int64_t>(centre.w) * centre.w; }
  __device__ Neighbourhood<ExactNeighbours> of(const DualEdgeProblem& p) const {
    return {*this, weight(), p.common.alpha, p.common.ghost_reach, true};
  }
};
__device__ inline ExactNeighbours exact_neighbours(const DualEdgeProblem& p,
                                                   const DualEdgeMemory& m, const BlockBalls& s,
                                                   int b) {
  return {m.index + s.entry0[b], p.balls, s.ball[b]};
}

}  // namespace alphascope::gpu
