// The CUDA executor's kernels of the facet engine. One block takes a run of balls through the stages:
// neighbours (kernel I), facets in single precision with certified errors (kernel II), and writes the
// simplices whose lowest vertex is one of its balls. A ball with an undecided facet goes, whole, to
// the same kernel with exact integers (kernel III). The per-facet bodies are core/complex/facet_*.hpp.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/complex/facet_float.hpp"
#include "core/geometry/perturbation.hpp"

namespace alphascope::gpu {

inline constexpr int kBlockThreads = 128;
inline constexpr int kTile = 8;  // lanes that search the neighbours of one ball together

// Sides of a polygon that fit the hot kernel's local memory; a larger facet goes to kernel III.
inline constexpr int kFloatSides = 20;
inline constexpr int kExactSides = 64;

// What all kernels know about the request; passed by value.
struct Problem {
  int ball_count;
  int4 origin;  // of the grid (w unused), lattice units
  int cell_width, nx, ny, nz;
  double alpha;           // square lattice units
  float scale;            // power of two: scaled = lattice * scale
  int balls_per_block;
  int list_capacity;      // neighbours of a ball that fit the block's memory
  int staging_capacity;   // simplices of one dimension that fit
  bool narrow;            // every predicate fits 128-bit integers
};

// Balls in cell order.
struct SortedBalls {
  const int4* ball;         // x, y, z, radius
  const std::uint32_t* index;  // in the BallSet
  const float* reach;       // sqrt(w + alpha), rounded up, lattice units
  const std::uint32_t* cell_start;
  const std::uint32_t* alive;  // one number: balls before the dead ones
};

// Simplices of one dimension on the device, in the order in which blocks finished.
template <int N>
struct DeviceSimplices {
  std::uint32_t* vertices;  // N per simplex
  float* value;             // null when only tetrahedra are asked for
  std::uint8_t* simplex_class;
  std::uint32_t capacity;
  std::uint32_t* cursor;    // simplices written (may pass capacity: then nothing counts)
  std::uint32_t* start;     // per ball: its first simplex
  std::uint32_t* count;     // per ball
};

struct Output {
  DeviceSimplices<2> edges;
  DeviceSimplices<3> triangles;
  DeviceSimplices<4> tetrahedra;
  std::uint8_t* vertex_state;   // per ball: 0 absent, 1 attached, 2 unattached
  std::uint32_t* exact_list;    // slots of balls for kernel III
  std::uint32_t* exact_count;
  std::uint32_t* needed_list;      // largest neighbour list met
  std::uint32_t* needed_staging;   // largest number of simplices of one dimension in a block
  std::uint32_t* failures;         // facets that even kernel III could not hold
};

__device__ inline int grid_cell(int coordinate, int lower, int width, int count) {
  const int cell = (coordinate - lower) / width;
  return cell < count ? cell : count - 1;
}

// ---- cells -------------------------------------------------------------------------------------

__global__ void assign_cells(Problem p, const int4* balls, std::uint32_t* cell_count,
                             uint2* cell_and_rank) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= p.ball_count) return;
  const int4 b = balls[i];
  const double square = static_cast<double>(static_cast<std::int64_t>(b.w) * b.w) + p.alpha;
  std::uint32_t cell = p.nx * p.ny * p.nz;  // the dead: hidden (negative radius) or empty at alpha
  if (b.w > 0 && square >= 0) {
    const int cx = grid_cell(b.x, p.origin.x, p.cell_width, p.nx);
    const int cy = grid_cell(b.y, p.origin.y, p.cell_width, p.ny);
    const int cz = grid_cell(b.z, p.origin.z, p.cell_width, p.nz);
    cell = (cx * p.ny + cy) * p.nz + cz;
  }
  cell_and_rank[i] = make_uint2(cell, atomicAdd(&cell_count[cell], 1u));
}

__global__ void sort_into_cells(Problem p, const int4* balls, const uint2* cell_and_rank,
                                const std::uint32_t* cell_start, int4* sorted, std::uint32_t* index,
                                float* reach) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= p.ball_count) return;
  const int4 b = balls[i];
  const uint2 c = cell_and_rank[i];
  const std::uint32_t slot = cell_start[c.x] + c.y;
  sorted[slot] = b;
  index[slot] = i;
  const float square = static_cast<float>(static_cast<double>(static_cast<std::int64_t>(b.w) * b.w) + p.alpha);
  reach[slot] = sqrtf(fmaxf(square, 0.0f)) * (1.0f + 1e-6f);
}

// ---- facets ------------------------------------------------------------------------------------

// One ball's neighbours in the block's shared memory, ascending by index.
struct BlockNeighbours {
  const float4* vectors;        // scaled d and c
  const std::uint32_t* slots;
  const std::uint32_t* indices;
  const int4* sorted;
  int4 centre;                  // of ball i

  __device__ LiftedVector<float> scaled(int k) const {
    const float4 v = vectors[k];
    return {v.x, v.y, v.z, v.w};
  }
  __device__ LiftedInt lifted(int k) const {
    const int4 b = sorted[slots[k]];
    const std::int64_t x = b.x - centre.x, y = b.y - centre.y, z = b.z - centre.z;
    const std::int64_t w = static_cast<std::int64_t>(b.w) * b.w,
                       wi = static_cast<std::int64_t>(centre.w) * centre.w;
    return {x, y, z, x * x + y * y + z * z + wi - w};
  }
  __device__ std::uint32_t ball(int k) const { return indices[k]; }
};

// Simplices of the block's balls before they are ordered. Keys: ball of the block, then the slots of
// the other vertices in its neighbour list (12 bits each, which ascend with the ball indices), then
// two bits of class.
struct Staged {
  std::uint64_t key;
  float value;
};

struct BlockMemory {
  float4* vectors;         // balls_per_block * list_capacity of each
  float* reach;
  std::uint32_t *slots, *indices;
  std::uint32_t* found;    // unsorted slots of kernel I, then the queue of facets
  Staged* staged[3];       // edges, triangles, tetrahedra; staging_capacity each
  int* list_size;          // per ball of the block
  int* exact;              // per ball: 1 when undecided
  int* counters;           // 0-2 staged, 3 queue
};

__host__ __device__ inline std::size_t block_memory_bytes(int balls, int list, int staging, bool whole) {
  const std::size_t entries = static_cast<std::size_t>(balls) * list;
  return entries * (16 + 4 + 4 + 4 + 4) + static_cast<std::size_t>(staging) * 16 * (whole ? 3 : 1) +
         (2 * static_cast<std::size_t>(balls) + 16) * 4;
}

__device__ inline BlockMemory carve(unsigned char* shared, const Problem& p, bool whole) {
  BlockMemory m;
  const int entries = p.balls_per_block * p.list_capacity;
  m.vectors = reinterpret_cast<float4*>(shared);
  auto* staged = reinterpret_cast<Staged*>(m.vectors + entries);
  for (int d = 0; d < 3; ++d) {
    m.staged[d] = staged;
    if (whole && d < 2) staged += p.staging_capacity;
  }
  m.reach = reinterpret_cast<float*>(staged + p.staging_capacity);
  m.slots = reinterpret_cast<std::uint32_t*>(m.reach + entries);
  m.indices = m.slots + entries;
  m.found = m.indices + entries;
  m.list_size = reinterpret_cast<int*>(m.found + entries);
  m.exact = m.list_size + p.balls_per_block;
  m.counters = m.exact + p.balls_per_block;
  return m;
}

// Hands the simplices of one facet to the block's staging area.
struct StagingSink {
  const BlockMemory& memory;
  int capacity;
  int ball, j;

  __device__ void push(int dimension, std::uint64_t key, float value, int simplex_class) {
    const int at = atomicAdd(&memory.counters[dimension], 1);
    if (at < capacity) {
      memory.staged[dimension][at] = {
          key | static_cast<std::uint64_t>(ball) << 50 | static_cast<std::uint64_t>(j) << 38 |
              static_cast<std::uint64_t>(simplex_class),
          value};
    }
  }
  __device__ void edge(float value, int simplex_class) { push(0, 0, value, simplex_class); }
  __device__ void triangle(int k, float value, int simplex_class) {
    push(1, static_cast<std::uint64_t>(k) << 26, value, simplex_class);
  }
  __device__ void tetrahedron(int k, int l, float value) {
    const int low = k < l ? k : l, high = k < l ? l : k;
    push(2, static_cast<std::uint64_t>(low) << 26 | static_cast<std::uint64_t>(high) << 14, value, 2);
  }
  __device__ void tetrahedron(int k, int l) { tetrahedron(k, l, 0.0f); }
};

// Kernel I for one ball: a tile of lanes reads the 27 cells around it.
__device__ inline int search_neighbours(const Problem& p, const SortedBalls& balls,
                                        std::uint32_t slot, std::uint32_t* found, int lane,
                                        unsigned tile_mask, int tile_shift) {
  const int4 b = balls.ball[slot];
  const float reach = balls.reach[slot];
  const int cx = grid_cell(b.x, p.origin.x, p.cell_width, p.nx);
  const int cy = grid_cell(b.y, p.origin.y, p.cell_width, p.ny);
  const int cz = grid_cell(b.z, p.origin.z, p.cell_width, p.nz);
  const int z0 = max(cz - 1, 0), z1 = min(cz + 1, p.nz - 1);
  constexpr float kMargin = 1.0f + 1.0f / (1 << 17);  // above all roundings of the test
  int count = 0;
  for (int ax = max(cx - 1, 0); ax <= min(cx + 1, p.nx - 1); ++ax) {
    for (int ay = max(cy - 1, 0); ay <= min(cy + 1, p.ny - 1); ++ay) {
      const int row = (ax * p.ny + ay) * p.nz;
      const std::uint32_t begin = balls.cell_start[row + z0], end = balls.cell_start[row + z1 + 1];
      for (std::uint32_t base = begin; base < end; base += kTile) {
        const std::uint32_t t = base + lane;
        bool hit = false;
        if (t < end && t != slot) {
          const int4 o = balls.ball[t];
          const float dx = static_cast<float>(o.x - b.x), dy = static_cast<float>(o.y - b.y),
                      dz = static_cast<float>(o.z - b.z), sum = balls.reach[t] + reach;
          hit = fmaf(dx, dx, fmaf(dy, dy, dz * dz)) <= sum * sum * kMargin;
        }
        const unsigned hits = (__ballot_sync(tile_mask, hit) >> tile_shift) & ((1u << kTile) - 1);
        const int at = count + __popc(hits & ((1u << lane) - 1));
        if (hit && at < p.list_capacity) found[at] = t;
        count += __popc(hits);
      }
    }
  }
  return count;
}

// Orders one ball's list by index and fills its vectors. Lists are short: counting is quick.
__device__ inline void order_neighbours(const Problem& p, const SortedBalls& balls, std::uint32_t slot,
                                        const std::uint32_t* found, int count, int entry0,
                                        const BlockMemory& m, int lane) {
  const int4 b = balls.ball[slot];
  const std::int64_t wi = static_cast<std::int64_t>(b.w) * b.w;
  for (int a = lane; a < count; a += kTile) {
    const std::uint32_t t = found[a], index = balls.index[t];
    int rank = 0;
    for (int o = 0; o < count; ++o) rank += balls.index[found[o]] < index;
    const int4 q = balls.ball[t];
    const std::int64_t x = q.x - b.x, y = q.y - b.y, z = q.z - b.z;
    const std::int64_t c = x * x + y * y + z * z + wi - static_cast<std::int64_t>(q.w) * q.w;
    const int entry = entry0 + rank;
    m.vectors[entry] = make_float4(static_cast<float>(x) * p.scale, static_cast<float>(y) * p.scale,
                                   static_cast<float>(z) * p.scale,
                                   static_cast<float>(c) * p.scale * p.scale);
    m.reach[entry] = balls.reach[t] * p.scale;
    m.slots[entry] = t;
    m.indices[entry] = index;
  }
}

struct CommonTest {
  const float4* vectors;
  const float* reach;
  float4 j;
  float reach_j;
  int self;

  __device__ bool operator()(int k) const {
    const float4 v = vectors[k];
    const float x = v.x - j.x, y = v.y - j.y, z = v.z - j.z, sum = reach[k] + reach_j;
    constexpr float kMargin = 1.0f + 1.0f / (1 << 17);
    return k != self && fmaf(x, x, fmaf(y, y, z * z)) <= sum * sum * kMargin;
  }
};

// Kernel II of one facet. False when something could not be decided.
template <bool kWhole>
__device__ bool float_facet(const FacetInput<BlockNeighbours>& in, int count, const CommonTest& common,
                            float scale, float radius_square, StagingSink& sink) {
  float edge_value = 0;
  if (kWhole) {
    const Decision d = decide_edge<FilteredDecider>(in, &edge_value);
    if (d != Decision::in) return d == Decision::out;
  }
  const float4 j = common.j;
  // Any axis will do for the exact predicates as long as one is used throughout; the largest.
  const LiftedInt vj = in.neighbours.lifted(in.j);
  const FacetAxis axis = facet_axis(vj.x, vj.y, vj.z);
  const FloatFrame frame = make_float_frame({j.x, j.y, j.z, j.w}, axis);
  FloatPolygon<BlockNeighbours, kFloatSides> polygon(frame, in.neighbours,
                                                     static_cast<float>(in.ghost_reach) * scale);
  const ClipOutcome outcome = clip_float_facet(polygon, in, axis, count, common);
  if (outcome == ClipOutcome::empty) return true;
  if (outcome != ClipOutcome::unchanged) return false;
  if (kWhole) {
    signed char corner_in[kFloatSides];
    float corner_value[kFloatSides];
    return report_facet<FilteredDecider>(in, polygon, axis.axis, edge_value, {corner_in, corner_value}, sink);
  }
  const auto ball_j = in.neighbours.ball(in.j);
  for (int s = 0; s < polygon.size; ++s) {
    const int k = polygon.ids[s], l = polygon.ids[s + 1 == polygon.size ? 0 : s + 1];
    if (k < 0 || l < 0 || in.neighbours.ball(k) < ball_j || in.neighbours.ball(l) < ball_j) continue;
    int within = corner_within(frame, polygon.corners[s], radius_square);
    if (within == 0) {
      const Decision d = decide_tetrahedron<FilteredDecider>(in, k, l, nullptr);
      if (d == Decision::unknown) return false;
      within = static_cast<int>(d);
    }
    if (within > 0) sink.tetrahedron(k, l);
  }
  return true;
}

// Storage of an exact polygon in the local memory of a thread.
template <class Integer>
struct ExactPolygon {
  using Line = FacetLine<Integer>;
  const FacetFrame<Integer>& frame;
  const FacetInput<BlockNeighbours>& in;
  int size = 0;
  FacetCorner<Integer> corners[kExactSides];
  short ids[kExactSides];

  __device__ ExactPolygon(const FacetFrame<Integer>& f, const FacetInput<BlockNeighbours>& i)
      : frame(f), in(i) {}
  __device__ int capacity() const { return kExactSides; }
  __device__ int id(int s) const { return ids[s]; }
  __device__ Line line(int s) const {
    return frame.line(lifted_as<Integer>(in.side_vector(ids[s], frame.axis)));
  }
  __device__ void set_side(int s, int id, const Line&) { ids[s] = static_cast<short>(id); }
  __device__ void meet(int s, const Line& k, const Line& l) { corners[s].meet(k, l); }
  __device__ void move(int from, int to) {
    ids[to] = ids[from];
    corners[to] = corners[from];
  }
};

// Kernel III of one facet. False only when the polygon does not fit.
template <bool kWhole, class Integer>
__device__ bool exact_facet(const FacetInput<BlockNeighbours>& in, int count, const CommonTest& common,
                            StagingSink& sink) {
  float edge_value = 0;
  if (kWhole && decide_edge<ExactDecider>(in, &edge_value) == Decision::out) return true;
  const LiftedInt j = in.neighbours.lifted(in.j);
  const FacetAxis axis = facet_axis(j.x, j.y, j.z);
  const auto frame = make_facet_frame(lifted_as<Integer>(j), axis.axis, axis.negative);
  ExactPolygon<Integer> polygon(frame, in);
  start_polygon(polygon, frame, in.ghost_reach);
  for (int m = 0; m < count; ++m) {
    if (!common(m)) continue;
    const LiftedInt vm = in.neighbours.lifted(m);
    const auto line = frame.line(lifted_as<Integer>(vm));
    const auto side = [&](int s) {
      const int sign = sign_of(polygon.corners[s].beyond(line));
      if (sign != 0) return sign;
      const int k = polygon.ids[s], l = polygon.ids[s + 1 == polygon.size ? 0 : s + 1];
      return perturbed_cut(j, in.side_vector(k, axis.axis), k < 0, in.side_vector(l, axis.axis),
                           l < 0, vm);
    };
    const ClipOutcome outcome = clip(polygon, line, m, side);
    if (outcome == ClipOutcome::empty) return true;
    if (outcome == ClipOutcome::full) return false;
  }
  if (kWhole) {
    signed char corner_in[kExactSides];
    float corner_value[kExactSides];
    report_facet<ExactDecider>(in, polygon, axis.axis, edge_value, {corner_in, corner_value}, sink);
  } else {
    report_tetrahedra<ExactDecider>(in, polygon, sink);
  }
  return true;
}

// Writes the staged simplices of one dimension in order, and where each ball's are.
template <int N>
__device__ void write_staged(const Problem& p, const BlockMemory& m, const std::uint32_t* ball_index,
                             int balls, DeviceSimplices<N> out, std::uint32_t* needed_staging,
                             std::uint32_t* shared_base) {
  const int dimension = N - 2;
  Staged* staged = m.staged[dimension];
  const int all = m.counters[dimension];
  if (threadIdx.x == 0) atomicMax(needed_staging, static_cast<std::uint32_t>(all));
  const int n = min(all, p.staging_capacity);
  // Undecided balls write nothing here: kernel III does them again.
  constexpr std::uint64_t kDropped = ~std::uint64_t{0};
  for (int a = threadIdx.x; a < n; a += blockDim.x) {
    if (m.exact[staged[a].key >> 50]) staged[a].key = kDropped;
  }
  std::uint32_t kept = 0;
  for (int a0 = 0; a0 < n; a0 += static_cast<int>(blockDim.x)) {
    const int a = a0 + static_cast<int>(threadIdx.x);
    kept += __syncthreads_count(a < n && staged[a].key != kDropped);
  }
  if (threadIdx.x == 0) *shared_base = kept == 0 ? 0 : atomicAdd(out.cursor, kept);
  __syncthreads();
  const std::uint32_t base = *shared_base;
  // Per ball: the simplices of balls before it, and its own.
  for (int b = threadIdx.x; b < balls; b += blockDim.x) {
    if (m.exact[b]) continue;
    std::uint32_t before = 0, own = 0;
    for (int a = 0; a < n; ++a) {
      const std::uint64_t key = staged[a].key;
      if (key == kDropped) continue;
      before += (key >> 50) < static_cast<std::uint64_t>(b);
      own += (key >> 50) == static_cast<std::uint64_t>(b);
    }
    out.start[ball_index[b]] = base + before;
    out.count[ball_index[b]] = own;
  }
  for (int a = threadIdx.x; a < n; a += blockDim.x) {
    const Staged s = staged[a];
    if (s.key == kDropped) continue;
    std::uint32_t rank = 0;
    for (int o = 0; o < n; ++o) rank += staged[o].key < s.key;
    const std::uint32_t at = base + rank;
    if (at >= out.capacity) continue;
    const int b = static_cast<int>(s.key >> 50);
    const std::uint32_t* indices = m.indices + b * p.list_capacity;
    out.vertices[static_cast<std::size_t>(at) * N] = ball_index[b];
    for (int v = 1; v < N; ++v) {
      out.vertices[static_cast<std::size_t>(at) * N + v] = indices[(s.key >> (50 - 12 * v)) & 4095];
    }
    if (out.value != nullptr) {
      out.value[at] = s.value;
      out.simplex_class[at] = static_cast<std::uint8_t>(s.key & 3);
    }
  }
  __syncthreads();
}

// Balls [first, first + balls) of the sorted order, or one ball of the exact list.
template <bool kWhole, bool kExact, class Integer>
__device__ void process_balls(const Problem& p, const SortedBalls& sorted, const Output& out,
                              const BlockMemory& m, std::uint32_t first, int balls,
                              std::uint32_t* ball_index, std::uint32_t* shared_base) {
  const int lane = threadIdx.x % kTile, tile = threadIdx.x / kTile, tiles = blockDim.x / kTile;
  const int tile_shift = (threadIdx.x & 31) / kTile * kTile;
  const unsigned tile_mask = ((1u << kTile) - 1) << tile_shift;
  if (threadIdx.x < 4) m.counters[threadIdx.x] = 0;
  for (int b = threadIdx.x; b < balls; b += blockDim.x) {
    m.exact[b] = 0;
    ball_index[b] = sorted.index[first + b];
  }
  for (int b = tile; b < balls; b += tiles) {
    std::uint32_t* found = m.found + b * p.list_capacity;
    const int all = search_neighbours(p, sorted, first + b, found, lane, tile_mask, tile_shift);
    const int count = min(all, p.list_capacity);
    __syncwarp(tile_mask);
    order_neighbours(p, sorted, first + b, found, count, b * p.list_capacity, m, lane);
    if (lane == 0) {
      m.list_size[b] = count;
      if (all > p.list_capacity) atomicMax(out.needed_list, static_cast<std::uint32_t>(all));
    }
  }
  __syncthreads();

  // The queue of facets worth clipping; `found` is free now.
  std::uint32_t* queue = m.found;
  for (int e = threadIdx.x; e < balls * p.list_capacity; e += blockDim.x) {
    const int b = e / p.list_capacity, j = e - b * p.list_capacity, n = m.list_size[b];
    if (j >= n || m.indices[e] < ball_index[b]) continue;
    if (!kWhole) {
      const int entry0 = b * p.list_capacity;
      const CommonTest common{m.vectors + entry0, m.reach + entry0, m.vectors[e], m.reach[e], j};
      int later = 0;
      for (int k = j + 1; k < n && later < 2; ++k) later += common(k);
      if (later < 2) continue;
    }
    queue[atomicAdd(&m.counters[3], 1)] = e;
  }
  __syncthreads();

  const int facets = m.counters[3];
  for (int f = threadIdx.x; f < facets; f += blockDim.x) {
    const int e = static_cast<int>(queue[f]), b = e / p.list_capacity, entry0 = b * p.list_capacity;
    const int4 centre = sorted.ball[first + b];
    const BlockNeighbours neighbours{m.vectors + entry0, m.slots + entry0, m.indices + entry0,
                                     sorted.ball, centre};
    const std::int64_t weight = static_cast<std::int64_t>(centre.w) * centre.w;
    const double square = static_cast<double>(weight) + p.alpha;
    // A power of two above the radius of the disc: the same in every precision.
    std::int64_t ghost = 4;
    const float radius = sqrtf(static_cast<float>(square)) * (1.0f + 1e-5f) + 2.0f;
    while (static_cast<float>(ghost) < radius) ghost *= 2;
    const FacetInput<BlockNeighbours> in{neighbours, e - entry0, weight, p.alpha, ghost, true};
    const CommonTest common{neighbours.vectors, m.reach + entry0, m.vectors[e], m.reach[e], e - entry0};
    StagingSink sink{m, p.staging_capacity, b, e - entry0};
    if (kExact) {
      if (!exact_facet<kWhole, Integer>(in, m.list_size[b], common, sink)) atomicAdd(out.failures, 1u);
    } else {
      const float radius_square = static_cast<float>(square) * p.scale * p.scale;
      if (!float_facet<kWhole>(in, m.list_size[b], common, p.scale, radius_square, sink)) {
        atomicExch(&m.exact[b], 1);
      }
    }
  }
  __syncthreads();

  if (!kExact) {
    for (int b = threadIdx.x; b < balls; b += blockDim.x) {
      if (m.exact[b]) out.exact_list[atomicAdd(out.exact_count, 1u)] = first + b;
    }
  }
  if (kWhole) {
    for (int b = threadIdx.x; b < balls; b += blockDim.x) {
      const int radius = sorted.ball[first + b].w;
      const double weight = static_cast<double>(static_cast<std::int64_t>(radius) * radius);
      std::uint8_t state = -weight > p.alpha ? 0 : 2;
      // A float keeps the sign of c; equality counts as attached (see BallFacets::process).
      for (int k = 0; k < m.list_size[b] && state == 2; ++k) {
        if (m.vectors[b * p.list_capacity + k].w <= 0.0f) state = 1;
      }
      out.vertex_state[ball_index[b]] = state;
    }
    write_staged<2>(p, m, ball_index, balls, out.edges, out.needed_staging, shared_base);
    write_staged<3>(p, m, ball_index, balls, out.triangles, out.needed_staging, shared_base);
  }
  write_staged<4>(p, m, ball_index, balls, out.tetrahedra, out.needed_staging, shared_base);
}

template <bool kWhole>
__global__ void __launch_bounds__(kBlockThreads) facets_filtered(Problem p, SortedBalls sorted, Output out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ std::uint32_t ball_index[64];
  __shared__ std::uint32_t base;
  const BlockMemory m = carve(shared, p, kWhole);
  const std::uint32_t alive = *sorted.alive;
  const std::uint32_t first = blockIdx.x * static_cast<std::uint32_t>(p.balls_per_block);
  if (first >= alive) return;
  const int balls = static_cast<int>(min(static_cast<std::uint32_t>(p.balls_per_block), alive - first));
  process_balls<kWhole, false, Int128>(p, sorted, out, m, first, balls, ball_index, &base);
}

// One ball at a time; p.balls_per_block is 1.
template <bool kWhole, class Integer>
__global__ void __launch_bounds__(kBlockThreads) facets_exact(Problem p, SortedBalls sorted, Output out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ std::uint32_t ball_index[1];
  __shared__ std::uint32_t base;
  const BlockMemory m = carve(shared, p, kWhole);
  const std::uint32_t count = *out.exact_count;
  for (std::uint32_t n = blockIdx.x; n < count; n += gridDim.x) {
    process_balls<kWhole, true, Integer>(p, sorted, out, m, out.exact_list[n], 1, ball_index, &base);
    __syncthreads();
  }
}

// ---- order -------------------------------------------------------------------------------------

// Moves every simplex to its lexicographic place: the prefix sum of its lowest ball, and its rank
// among that ball's.
template <int N>
__global__ void place(DeviceSimplices<N> from, const std::uint32_t* offset, std::uint32_t* vertices,
                      float* value, std::uint8_t* simplex_class) {
  const std::uint32_t count = min(*from.cursor, from.capacity);
  for (std::uint32_t t = blockIdx.x * blockDim.x + threadIdx.x; t < count; t += gridDim.x * blockDim.x) {
    const std::uint32_t i = from.vertices[static_cast<std::size_t>(t) * N];
    const std::uint32_t to = offset[i] + (t - from.start[i]);
    if constexpr (N == 4) {
      reinterpret_cast<uint4*>(vertices)[to] = reinterpret_cast<const uint4*>(from.vertices)[t];
    } else if constexpr (N == 2) {
      reinterpret_cast<uint2*>(vertices)[to] = reinterpret_cast<const uint2*>(from.vertices)[t];
    } else {
      for (int v = 0; v < N; ++v) {
        vertices[static_cast<std::size_t>(to) * N + v] = from.vertices[static_cast<std::size_t>(t) * N + v];
      }
    }
    if (value != nullptr) {
      value[to] = from.value[t];
      simplex_class[to] = from.simplex_class[t];
    }
  }
}

// Floats as unsigned numbers of the same order, for atomicMin.
__device__ inline std::uint32_t ordered_bits(float value) {
  const std::uint32_t bits = __float_as_uint(value);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
__device__ inline float from_ordered_bits(std::uint32_t bits) {
  return __uint_as_float(bits & 0x80000000u ? bits & 0x7fffffffu : ~bits);
}

// Per ball: has an edge (1), has an edge that is not interior (2), and its nearest edge.
__global__ void gather_vertices(const std::uint32_t* edges, const float* value,
                                const std::uint8_t* simplex_class, const std::uint32_t* cursor,
                                const std::uint8_t* state, std::uint32_t* flags,
                                std::uint32_t* nearest) {
  const std::uint32_t count = *cursor;
  for (std::uint32_t e = blockIdx.x * blockDim.x + threadIdx.x; e < count; e += gridDim.x * blockDim.x) {
    const std::uint32_t flag = simplex_class[e] == 2 ? 1u : 3u;
    for (int end = 0; end < 2; ++end) {
      const std::uint32_t v = edges[2 * static_cast<std::size_t>(e) + end];
      if ((flags[v] & flag) != flag) atomicOr(&flags[v], flag);
      if (state[v] == 1) atomicMin(&nearest[v], ordered_bits(value[e]));
    }
  }
}

__global__ void mark_vertices(int balls, const std::uint8_t* state, const std::uint32_t* flags,
                              std::uint32_t* present) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < balls) present[i] = state[i] == 2 || (state[i] == 1 && (flags[i] & 1));
}

__global__ void place_vertices(int balls, const int4* ball, const std::uint8_t* state,
                               const std::uint32_t* flags, const std::uint32_t* nearest,
                               const std::uint32_t* present, const std::uint32_t* offset,
                               std::uint32_t* vertices, float* value, std::uint8_t* simplex_class) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= balls || !present[i]) return;
  const std::uint32_t to = offset[i];
  vertices[to] = i;
  const double weight = static_cast<double>(static_cast<std::int64_t>(ball[i].w) * ball[i].w);
  value[to] = state[i] == 1 ? from_ordered_bits(nearest[i]) : static_cast<float>(-weight);
  simplex_class[to] = !(flags[i] & 1) ? 0 : (flags[i] & 2) ? 1 : 2;
}

}  // namespace alphascope::gpu
