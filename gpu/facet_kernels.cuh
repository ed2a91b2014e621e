// The CUDA executor's kernels of the facet engine. One block takes a run of balls through the
// stages: neighbours (kernel I), facets in single precision with certified errors (kernel II), and
// writes the simplices whose lowest vertex is one of its balls. A ball with an undecided facet
// goes, whole, to the same kernel with exact integers (kernel III). The per-facet bodies are
// core/complex/facet_*.hpp.
#pragma once

#include "core/complex/facet_float.hpp"
#include "core/geometry/perturbation.hpp"
#include "gpu/problem.cuh"

namespace alphascope::gpu {

// Sides of a polygon that fit the hot kernel's local memory; a larger facet goes to kernel III.
inline constexpr int kFloatSides = 20;
inline constexpr int kExactSides = 64;

// Wide enough for every predicate within the lattice's bounds. So few facets need it (9 corners of
// a million balls at alpha 1.4) that 128 bits, where they suffice, would gain nothing.
using ExactInteger = WideInt<4>;

struct Output {
  DeviceSimplices<2> edges;
  DeviceSimplices<3> triangles;
  DeviceSimplices<4> tetrahedra;
  std::uint8_t* vertex_state;  // per ball: 0 absent, 1 attached, 2 unattached
  std::uint32_t* exact_list;   // slots of balls for kernel III
  std::uint32_t* exact_count;
  std::uint32_t* needed_list;     // largest neighbour list met
  std::uint32_t* needed_staging;  // largest number of simplices of one dimension in a block
  std::uint32_t* failures;        // facets that even kernel III could not hold
};

// ---- facets ------------------------------------------------------------------------------------

// One ball's neighbours in the block's shared memory, nearest bisector first: facets that die, die
// early. `indices` are those in the BallSet.
struct BlockNeighbours {
  const float4* vectors;  // scaled d and c
  const std::uint32_t* slots;
  const std::uint32_t* indices;
  const int4* sorted;
  int4 centre;  // of ball i

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

// Simplices of the block's balls before they are ordered. Keys: ball of the block, then the other
// vertices as ranks by index among its neighbours (12 bits each), then two bits of class.
struct Staged {
  std::uint64_t key;
  float value;
};

// Which neighbours can cut a facet: one bit each.
__host__ __device__ inline int mask_words(const Problem& p) {
  return (p.list_capacity + 31) / 32;
}

struct BlockMemory {
  float4* vectors;  // balls_per_block * list_capacity of each
  float* reach;
  std::uint32_t *slots, *indices;
  std::uint32_t *rank, *by_rank;  // rank of an entry by index; and the index of a rank
  // Before the lists are ordered:
  std::uint32_t *found, *found_index;
  float* found_key;
  // Afterwards, in the same place:
  std::uint32_t *queue, *masks;  // facets to clip (entry of j), and mask_words of each entry
  Staged* staged[3];             // edges, triangles, tetrahedra; staging_capacity each
  int* list_size;                // per ball of the block
  int* exact;                    // per ball: 1 when undecided
  int* counters;                 // 0-2 staged, 3 queue, 4 queue head, 5 longest list
};

__host__ __device__ inline std::size_t reused_words(const Problem& p) {
  const std::size_t entries = static_cast<std::size_t>(p.balls_per_block) * p.list_capacity;
  const std::size_t later = entries * (1 + mask_words(p));
  return later > 3 * entries ? later : 3 * entries;
}
__host__ __device__ inline std::size_t block_memory_bytes(const Problem& p) {
  const std::size_t entries = static_cast<std::size_t>(p.balls_per_block) * p.list_capacity;
  return entries * (16 + 5 * 4) + reused_words(p) * 4 +
         static_cast<std::size_t>(p.staging_capacity) * 16 * 3 +
         (2 * static_cast<std::size_t>(p.balls_per_block) + 16) * 4;
}

__device__ inline BlockMemory carve(unsigned char* shared, const Problem& p) {
  BlockMemory m;
  const int entries = p.balls_per_block * p.list_capacity;
  m.vectors = reinterpret_cast<float4*>(shared);
  auto* staged = reinterpret_cast<Staged*>(m.vectors + entries);
  for (int d = 0; d < 3; ++d) {
    m.staged[d] = staged;
    if (d < 2) staged += p.staging_capacity;
  }
  m.reach = reinterpret_cast<float*>(staged + p.staging_capacity);
  m.slots = reinterpret_cast<std::uint32_t*>(m.reach + entries);
  m.indices = m.slots + entries;
  m.rank = m.indices + entries;
  m.by_rank = m.rank + entries;
  m.found = m.by_rank + entries;
  m.found_index = m.found + entries;
  m.found_key = reinterpret_cast<float*>(m.found_index + entries);
  m.queue = m.found;
  m.masks = m.found + entries;
  m.list_size = reinterpret_cast<int*>(m.found + reused_words(p));
  m.exact = m.list_size + p.balls_per_block;
  m.counters = m.exact + p.balls_per_block;
  return m;
}

// Hands the simplices of one facet to the block's staging area.
struct StagingSink {
  const BlockMemory& memory;
  int capacity;
  int ball;
  const std::uint32_t* rank;  // of this ball's neighbours
  int j;

  __device__ void push(int dimension, std::uint64_t key, float value, int simplex_class) {
    const int at = atomicAdd(&memory.counters[dimension], 1);
    if (at < capacity) {
      memory.staged[dimension][at] = {key | static_cast<std::uint64_t>(ball) << 50 |
                                          static_cast<std::uint64_t>(rank[j]) << 38 |
                                          static_cast<std::uint64_t>(simplex_class),
                                      value};
    }
  }
  __device__ void edge(float value, int simplex_class) { push(0, 0, value, simplex_class); }
  __device__ void triangle(int k, float value, int simplex_class) {
    push(1, static_cast<std::uint64_t>(rank[k]) << 26, value, simplex_class);
  }
  __device__ void tetrahedron(int k, int l, float value) {
    const std::uint32_t a = rank[k], b = rank[l], low = min(a, b), high = max(a, b);
    push(2, static_cast<std::uint64_t>(low) << 26 | static_cast<std::uint64_t>(high) << 14, value,
         2);
  }
  __device__ void tetrahedron(int k, int l) { tetrahedron(k, l, 0.0f); }
};

// Orders one ball's list by the distance of the bisectors, and ranks it by index. Lists are short:
// counting is quick.
__device__ inline void order_neighbours(const Problem& p, const SortedBalls& balls,
                                        std::uint32_t slot, int count, int entry0,
                                        const BlockMemory& m, int lane) {
  const int4 b = balls.ball[slot];
  const std::int64_t wi = static_cast<std::int64_t>(b.w) * b.w;
  const std::uint32_t* found = m.found + entry0;
  std::uint32_t* found_index = m.found_index + entry0;
  float* found_key = m.found_key + entry0;
  for (int a = lane; a < count; a += kSearchLanes) {
    const int4 q = balls.ball[found[a]];
    const float x = static_cast<float>(q.x - b.x), y = static_cast<float>(q.y - b.y),
                z = static_cast<float>(q.z - b.z), square = x * x + y * y + z * z;
    found_index[a] = balls.index[found[a]];
    found_key[a] =
        (square + static_cast<float>(wi - static_cast<std::int64_t>(q.w) * q.w)) * rsqrtf(square);
  }
  __syncwarp();
  for (int a = lane; a < count; a += kSearchLanes) {
    const std::uint32_t t = found[a], index = found_index[a];
    const float key = found_key[a];
    int nearer = 0, rank = 0;
    for (int o = 0; o < count; ++o) {
      const std::uint32_t other = found_index[o];
      rank += other < index;
      nearer += found_key[o] < key || (found_key[o] == key && other < index);
    }
    const int4 q = balls.ball[t];
    const std::int64_t x = q.x - b.x, y = q.y - b.y, z = q.z - b.z;
    const std::int64_t c = x * x + y * y + z * z + wi - static_cast<std::int64_t>(q.w) * q.w;
    const int entry = entry0 + nearer;
    m.vectors[entry] =
        make_float4(static_cast<float>(x) * p.scale, static_cast<float>(y) * p.scale,
                    static_cast<float>(z) * p.scale, static_cast<float>(c) * p.scale * p.scale);
    m.reach[entry] = balls.near[t].w * p.scale;
    m.slots[entry] = t;
    m.indices[entry] = index;
    m.rank[entry] = rank;
    m.by_rank[entry0 + rank] = index;
  }
}

// Writes the mask of the neighbours that meet j as well as i.
__device__ inline void mask_common(const Problem& p, const BlockMemory& m, int entry0, int j,
                                   int n) {
  const float4 vj = m.vectors[entry0 + j];
  const float reach_j = m.reach[entry0 + j];
  std::uint32_t* mask = m.masks + (entry0 + j) * mask_words(p);
  constexpr float kMargin = 1.0f + 1.0f / (1 << 17);
  for (int w = 0; w * 32 < n; ++w) {
    std::uint32_t bits = 0;
    const int end = min(n, w * 32 + 32);
    for (int k = w * 32; k < end; ++k) {
      const float4 v = m.vectors[entry0 + k];
      const float x = v.x - vj.x, y = v.y - vj.y, z = v.z - vj.z,
                  sum = m.reach[entry0 + k] + reach_j;
      if (k != j && fmaf(x, x, fmaf(y, y, z * z)) <= sum * sum * kMargin) {
        bits |= 1u << (k & 31);
      }
    }
    mask[w] = bits;
  }
}

// A facet in the making: one lane takes it through its cuts, then takes the next.
struct FloatFacet {
  FloatFrame frame;
  FacetAxis axis;
  int entry0, ball, j, words, word;
  std::uint32_t bits;  // of the current mask word, those not yet used
  float edge_value;
};

__device__ inline FacetAxis float_axis(const float4& v) {
  const float x = fabsf(v.x), y = fabsf(v.y), z = fabsf(v.z);
  if (x >= y && x >= z) return {0, v.x < 0};
  if (y >= z) return {1, v.y < 0};
  return {2, v.z < 0};
}

// Storage of an exact polygon in the local memory of a thread.
struct ExactPolygon {
  using Line = FacetLine<ExactInteger>;
  const FacetFrame<ExactInteger>& frame;
  const FacetInput<BlockNeighbours>& in;
  int size = 0;
  FacetCorner<ExactInteger> corners[kExactSides];
  short ids[kExactSides];

  __device__ ExactPolygon(const FacetFrame<ExactInteger>& f, const FacetInput<BlockNeighbours>& i)
      : frame(f), in(i) {}
  __device__ int capacity() const { return kExactSides; }
  __device__ int id(int s) const { return ids[s]; }
  __device__ Line line(int s) const {
    return frame.line(lifted_as<ExactInteger>(in.side_vector(ids[s], frame.axis)));
  }
  __device__ void set_side(int s, int id, const Line&) { ids[s] = static_cast<short>(id); }
  __device__ void meet(int s, const Line& k, const Line& l) { corners[s].meet(k, l); }
  __device__ void move(int from, int to) {
    ids[to] = ids[from];
    corners[to] = corners[from];
  }
};

// Kernel III of one facet. False only when the polygon does not fit.
__device__ bool exact_facet(const FacetInput<BlockNeighbours>& in, const std::uint32_t* mask,
                            int count, StagingSink& sink) {
  float edge_value = 0;
  if (decide_edge<ExactDecider>(in, &edge_value) == Decision::out) return true;
  const LiftedInt j = in.neighbours.lifted(in.j);
  const FacetAxis axis = facet_axis(j.x, j.y, j.z);
  const auto frame = make_facet_frame(lifted_as<ExactInteger>(j), axis.axis, axis.negative);
  ExactPolygon polygon(frame, in);
  start_polygon(polygon, frame, in.ghost_reach);
  for (int m = 0; m < count; ++m) {
    if (!(mask[m >> 5] >> (m & 31) & 1)) continue;
    const LiftedInt vm = in.neighbours.lifted(m);
    const auto line = frame.line(lifted_as<ExactInteger>(vm));
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
  signed char corner_in[kExactSides];
  float corner_value[kExactSides];
  report_facet<ExactDecider>(in, polygon, axis.axis, edge_value, {corner_in, corner_value}, sink);
  return true;
}

// Writes the staged simplices of one dimension in order, and where each ball's are.
template <int N>
__device__ void write_staged(const Problem& p, const BlockMemory& m,
                             const std::uint32_t* ball_index, int balls, DeviceSimplices<N> out,
                             std::uint32_t* needed_staging, std::uint32_t* shared_base) {
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
    const std::uint32_t* by_rank = m.by_rank + b * p.list_capacity;
    out.vertices[static_cast<std::size_t>(at) * N] = ball_index[b];
    for (int v = 1; v < N; ++v) {
      out.vertices[static_cast<std::size_t>(at) * N + v] = by_rank[(s.key >> (50 - 12 * v)) & 4095];
    }
    if (out.value != nullptr) {
      out.value[at] = s.value;
      out.simplex_class[at] = static_cast<std::uint8_t>(s.key & 3);
    }
  }
  __syncthreads();
}

// What a facet's templates need to know, from the block's memory.
struct FacetPlace {
  BlockNeighbours neighbours;
  std::int64_t weight;

  __device__ FacetPlace(const BlockMemory& m, const SortedBalls& sorted, std::uint32_t slot,
                        int entry0)
      : neighbours{m.vectors + entry0, m.slots + entry0, m.indices + entry0, sorted.ball,
                   sorted.ball[slot]},
        weight(static_cast<std::int64_t>(neighbours.centre.w) * neighbours.centre.w) {}
};

// The rare corner that single precision leaves open, in double. Out of line: its registers are not
// the loop's. Integers here as well would spare kernel III's 55 us, but the 246 registers that they
// take slow the whole kernel down (1K4C, alpha 10, H200: 2.0 ms against 1.3).
__device__ __noinline__ int corner_in_double(const Problem& p, const SortedBalls& sorted,
                                             const BlockMemory& m, std::uint32_t first,
                                             const FloatFacet& f, int k, int l, int cutter) {
  const FacetPlace place(m, sorted, first + f.ball, f.entry0);
  const FacetInput<BlockNeighbours> in{place.neighbours, f.j,           place.weight,
                                       p.alpha,          p.ghost_reach, true};
  return corner_cut_filtered(in.neighbours.lifted(f.j), f.axis, in.side_vector(k, f.axis.axis),
                             in.side_vector(l, f.axis.axis), in.neighbours.lifted(cutter));
}

// Kernel II over the block's queue: each lane clips its facet, one neighbour a turn, and fetches
// the next facet when its own is finished, so that short lives do not wait for long ones.
__device__ void clip_queue(const Problem& p, const SortedBalls& sorted, const BlockMemory& m,
                           std::uint32_t first, int facets) {
  FloatFacet f;
  // The polygon refers to these two, which change with the facet.
  BlockNeighbours neighbours{m.vectors, m.slots, m.indices, sorted.ball, make_int4(0, 0, 0, 0)};
  FloatPolygon<BlockNeighbours, kFloatSides> polygon(f.frame, neighbours,
                                                     static_cast<float>(p.ghost_reach) * p.scale);
  FloatBox box;
  const auto bound_polygon = [&] {
    box.clear();
    for (int s = 0; s < polygon.size; ++s) box.add(polygon.corners[s]);
    box.finish();
  };
  bool active = false;
  for (;;) {
    if (!active) {
      const int q = atomicAdd(&m.counters[4], 1);
      if (q >= facets) break;
      const int e = static_cast<int>(m.queue[q]);
      f.ball = e / p.list_capacity;
      f.entry0 = f.ball * p.list_capacity;
      f.j = e - f.entry0;
      f.words = (m.list_size[f.ball] + 31) >> 5;
      f.word = 0;
      f.bits = m.masks[e * mask_words(p)];
      const float4 vj = m.vectors[e];
      f.axis = float_axis(vj);
      f.frame = make_float_frame({vj.x, vj.y, vj.z, vj.w}, f.axis);
      neighbours.vectors = m.vectors + f.entry0;
      start_polygon(polygon, ghost_line(kGhostYZ, polygon.ghost_reach),
                    ghost_line(kGhostY, polygon.ghost_reach),
                    ghost_line(kGhostZ, polygon.ghost_reach));
      bound_polygon();
      active = true;
      const FacetPlace place(m, sorted, first + f.ball, f.entry0);
      const FacetInput<BlockNeighbours> in{place.neighbours, f.j,           place.weight,
                                           p.alpha,          p.ghost_reach, true};
      const Decision d = decide_edge<FilteredDecider>(in, &f.edge_value);
      if (d == Decision::unknown) atomicExch(&m.exact[f.ball], 1);
      active = d == Decision::in;
      continue;
    }
    while (f.bits == 0 && f.word + 1 < f.words)
      f.bits = m.masks[(f.entry0 + f.j) * mask_words(p) + ++f.word];
    if (f.bits == 0) {  // all cuts made
      const FacetPlace place(m, sorted, first + f.ball, f.entry0);
      const FacetInput<BlockNeighbours> in{place.neighbours, f.j,           place.weight,
                                           p.alpha,          p.ghost_reach, true};
      StagingSink sink{m, p.staging_capacity, f.ball, m.rank + f.entry0, f.j};
      signed char corner_in[kFloatSides];
      float corner_value[kFloatSides];
      if (!report_facet<FilteredDecider>(in, polygon, f.axis.axis, f.edge_value,
                                         {corner_in, corner_value}, sink)) {
        atomicExch(&m.exact[f.ball], 1);
      }
      active = false;
      continue;
    }
    const int k = f.word * 32 + __ffs(static_cast<int>(f.bits)) - 1;
    f.bits &= f.bits - 1;
    const FloatSideTest test(f.frame.line(neighbours.scaled(k)));
    if (test.spares(box)) continue;
    const auto side = [&](int s) {
      const int sign = test.side(polygon.corners[s]);
      return sign != 0 ? sign
                       : corner_in_double(p, sorted, m, first, f, polygon.ids[s],
                                          polygon.ids[s + 1 == polygon.size ? 0 : s + 1], k);
    };
    const ClipOutcome outcome = clip(polygon, test.line, k, side);
    if (outcome == ClipOutcome::uncertain || outcome == ClipOutcome::full) {
      atomicExch(&m.exact[f.ball], 1);
      active = false;
    } else if (outcome == ClipOutcome::empty) {
      active = false;
    } else if (outcome == ClipOutcome::changed) {
      bound_polygon();
    }
  }
}

// Balls [first, first + balls) of the sorted order, or one ball of the exact list.
template <bool kExact>
__device__ void process_balls(const Problem& p, const SortedBalls& sorted, const Output& out,
                              const BlockMemory& m, std::uint32_t first, int balls,
                              std::uint32_t* ball_index, std::uint32_t* shared_base) {
  __shared__ Surroundings surroundings[kBlockThreads / kSearchLanes];
  const int lane = threadIdx.x & (kSearchLanes - 1);
  if (threadIdx.x < 6) m.counters[threadIdx.x] = 0;
  for (int b = threadIdx.x; b < balls; b += blockDim.x) {
    m.exact[b] = 0;
    ball_index[b] = sorted.index[first + b];
  }
  // Two balls a warp; of an odd last pair, the second half repeats the first's reads in vain.
  for (int pair = threadIdx.x >> 5; 2 * pair < balls; pair += kBlockThreads / 32) {
    const int b = 2 * pair + ((threadIdx.x & kSearchLanes) != 0 && 2 * pair + 1 < balls);
    const bool active = (threadIdx.x & kSearchLanes) == 0 || 2 * pair + 1 < balls;
    const int entry0 = b * p.list_capacity;
    const int all = search_neighbours(p, sorted, first + b, active,
                                      surroundings[threadIdx.x / kSearchLanes], m.found + entry0);
    const int count = min(all, p.list_capacity);
    order_neighbours(p, sorted, first + b, count, entry0, m, lane);
    if (lane == 0 && active) {
      m.list_size[b] = count;
      atomicMax(&m.counters[5], all);
    }
  }
  __syncthreads();

  // The queue of facets worth clipping, in the place of the unordered lists.
  for (int e = threadIdx.x; e < balls * p.list_capacity; e += blockDim.x) {
    const int b = e / p.list_capacity, j = e - b * p.list_capacity, n = m.list_size[b];
    if (j >= n || m.indices[e] < ball_index[b]) continue;
    mask_common(p, m, b * p.list_capacity, j, n);
    m.queue[atomicAdd(&m.counters[3], 1)] = e;
  }
  __syncthreads();

  const int facets = m.counters[3];
  if constexpr (kExact) {
    for (int f = threadIdx.x; f < facets; f += blockDim.x) {
      const int e = static_cast<int>(m.queue[f]), b = e / p.list_capacity,
                entry0 = b * p.list_capacity;
      const FacetPlace place(m, sorted, first + b, entry0);
      const FacetInput<BlockNeighbours> in{place.neighbours, e - entry0,    place.weight,
                                           p.alpha,          p.ghost_reach, true};
      StagingSink sink{m, p.staging_capacity, b, m.rank + entry0, e - entry0};
      if (!exact_facet(in, m.masks + e * mask_words(p), m.list_size[b], sink))
        atomicAdd(out.failures, 1u);
    }
  } else {
    clip_queue(p, sorted, m, first, facets);
  }
  __syncthreads();

  if (threadIdx.x == 0) {
    atomicMax(out.needed_list, static_cast<std::uint32_t>(m.counters[5]));
  }
  if (!kExact) {
    for (int b = threadIdx.x; b < balls; b += blockDim.x) {
      if (m.exact[b]) out.exact_list[atomicAdd(out.exact_count, 1u)] = first + b;
    }
  }
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
  write_staged<4>(p, m, ball_index, balls, out.tetrahedra, out.needed_staging, shared_base);
}

__global__ void __launch_bounds__(kBlockThreads)
    facets_filtered(Problem p, SortedBalls sorted, Output out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ std::uint32_t ball_index[kMaxBallsPerBlock];
  __shared__ std::uint32_t base;
  const BlockMemory m = carve(shared, p);
  const std::uint32_t alive = *sorted.alive;
  const std::uint32_t first = blockIdx.x * static_cast<std::uint32_t>(p.balls_per_block);
  if (first >= alive) return;
  const int balls =
      static_cast<int>(min(static_cast<std::uint32_t>(p.balls_per_block), alive - first));
  process_balls<false>(p, sorted, out, m, first, balls, ball_index, &base);
}

// One ball at a time; p.balls_per_block is 1.
__global__ void __launch_bounds__(kBlockThreads)
    facets_exact(Problem p, SortedBalls sorted, Output out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ std::uint32_t ball_index[1];
  __shared__ std::uint32_t base;
  const BlockMemory m = carve(shared, p);
  const std::uint32_t count = *out.exact_count;
  for (std::uint32_t n = blockIdx.x; n < count; n += gridDim.x) {
    process_balls<true>(p, sorted, out, m, out.exact_list[n], 1, ball_index, &base);
    __syncthreads();
  }
}

// ---- order -------------------------------------------------------------------------------------

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
                                std::uint32_t capacity, const std::uint8_t* state,
                                std::uint32_t* flags, std::uint32_t* nearest) {
  const std::uint32_t count = *cursor;
  if (count > capacity) return;
  for (std::uint32_t e = blockIdx.x * blockDim.x + threadIdx.x; e < count;
       e += gridDim.x * blockDim.x) {
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
