// The CUDA executor of "tetrahedra only": one block takes a run of balls through neighbours (kernel
// I: lists, which neighbours meet, triangles ijk worth a look) and dual edges in single precision
// with certified errors (kernel II), and writes the tetrahedra whose lowest vertex is one of its
// balls. A ball with an undecided dual edge goes, whole, to the same kernel with double precision
// and exact integers (kernel III). The per-triangle bodies are
// core/complex/triangle_tetrahedra.hpp.
#pragma once

#include "gpu/dual_edge_block.cuh"

namespace alphascope::gpu {

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
  __device__ std::uint32_t ball(int k) const { return indices[k]; }
};

// Kernel III of one triangle: double precision, then integers. Not inlined: it is rare and large.
__device__ __noinline__ TriangleEnds decided_ends(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                                  int4 centre, const Triangle& t) {
  const ExactNeighbours neighbours{m.index + t.entry0, p.balls, centre};
  const std::int64_t weight = static_cast<std::int64_t>(centre.w) * centre.w;
  const TriangleEnds ends =
      filtered_ends<double>(t, p.words, static_cast<double>(weight) + p.common.alpha,
                            [&](int a) { return lifted_as<double>(neighbours.lifted(a)); });
  if (ends.known) return ends;
  const FacetInput<ExactNeighbours> in{neighbours,           t.j, weight, p.common.alpha,
                                       p.common.ghost_reach, true};
  return p.small_lattice ? exact_ends<Int128>(in, t, p.words)
                         : exact_ends<WideInt<4>>(in, t, p.words);
}

// Kernel I of the block's balls, half a warp each: their ordered lists. Balls without room are
// marked.
template <bool kExact>
__device__ inline void find_lists(const DualEdgeProblem& p, const SortedBalls& sorted,
                                  const DualEdgeOutput& out, const DualEdgeMemory& m, BlockBalls& s,
                                  std::uint32_t first, int balls) {
  const int lane = threadIdx.x & (kSearchLanes - 1), half = threadIdx.x & kSearchLanes;
  if (threadIdx.x == 0)
    s.entries = s.rows = s.next_triangle = s.next_work = s.survivors = s.kept = 0;
  if (threadIdx.x < kLengths) s.lengths[threadIdx.x] = 0;
  __syncthreads();
  for (int pair = threadIdx.x >> 5; 2 * pair < balls; pair += kBlockThreads / 32) {
    // Of an odd last pair, the second half repeats the first's reads in vain.
    const bool active = half == 0 || 2 * pair + 1 < balls;
    const int b = 2 * pair + (half != 0 && active);
    const std::uint32_t slot = first + b, index = sorted.index[slot];
    const int4 centre = sorted.ball[slot];
    const int all = search_neighbours(p.common, sorted, slot, active,
                                      s.surroundings[threadIdx.x / kSearchLanes], m.found);
    const int n = all <= p.common.list_capacity ? all : 0;
    int later = 0;
    for (int a = lane; a < n; a += kSearchLanes) {
      const std::uint32_t other = sorted.index[m.found[a]];
      m.found_index[a] = other;
      later += other > index;
    }
    for (int step = kSearchLanes / 2; step > 0; step /= 2)
      later += __shfl_xor_sync(~0u, later, step);
    __syncwarp();  // order_list reads what other lanes found
    int entry0 = 0, row0 = 0;
    if (lane == 0 && active) {
      entry0 = atomicAdd(&s.entries, n);
      row0 = atomicAdd(&s.rows, later);
    }
    entry0 = __shfl_sync(~0u, entry0, half);
    row0 = __shfl_sync(~0u, row0, half);
    const int row_room = static_cast<int>(p.capacity.rows);
    const bool room =
        n == all && entry0 + n <= static_cast<int>(p.capacity.entries) && row0 + later <= row_room;
    if (active) {
      // Rows of a ball without room still count: they are nobody's.
      for (int a = lane; a < later && row0 + a < row_room; a += kSearchLanes) {
        m.row_ball[row0 + a] = static_cast<std::uint8_t>(room ? b : kMaxBallsPerBlock);
      }
      if (room) order_list(p.common, sorted, m, centre, n, entry0);
    }
    if (active && lane == 0) {
      const double square =
          static_cast<double>(static_cast<std::int64_t>(centre.w) * centre.w) + p.common.alpha;
      s.radius_square[b] = static_cast<float>(square) * p.radius_scale;
      s.ball[b] = centre;
      s.index[b] = index;
      s.list[b] = room ? n : 0;
      s.later[b] = room ? later : 0;
      s.entry0[b] = entry0;
      s.row0[b] = row0;
      s.tetrahedra[b] = 0;
      s.exact[b] = room ? 0 : 2;
      if (kExact || all > p.common.list_capacity) note_largest(&out.statistics->longest_list, all);
      if (!kExact && blockIdx.x % kSampled == 0) {
        add(&out.statistics->balls, 1);
        add(&out.statistics->entries, all);
        add(&out.statistics->entry_squares, static_cast<std::uint64_t>(all) * all);
      }
    }
    __syncwarp();
  }
  __syncthreads();
  if (threadIdx.x == 0) s.rows = min(s.rows, static_cast<int>(p.capacity.rows));
  __syncthreads();
}

// Counting sort of triangles by how many cuts they have, the longest first, so that the lanes of a
// warp take about as long.
__device__ inline void sort_by_length(const DualEdgeMemory& m, BlockBalls& s, int count,
                                      int words) {
  const auto length = [&](int t) {
    const Triangle triangle(m, s, words, m.triangles[t]);
    int cuts = 0;
    for (int w = 0; w < words; ++w) cuts += __popc(triangle.common(w));
    return kLengths - 1 - min(cuts, kLengths - 1);
  };
  for (int t = threadIdx.x; t < count; t += kBlockThreads) atomicAdd(&s.lengths[length(t)], 1);
  __syncthreads();
  if (threadIdx.x < kLengths) s.lengths[threadIdx.x] = warp_scan(s.lengths[threadIdx.x]);
  __syncthreads();
  for (int t = threadIdx.x; t < count; t += kBlockThreads) {
    m.work[atomicAdd(&s.lengths[length(t)], 1)] = static_cast<std::uint16_t>(t);
  }
  __syncthreads();
}

// The scaled vectors of one ball's neighbours.
struct ScaledNeighbours {
  const float4* vectors;
  __device__ LiftedVector<float> operator()(int a) const {
    const float4 v = vectors[a];
    return {v.x, v.y, v.z, v.w};
  }
};

// The list of triangles of three balls that meet and have a fourth: of each ball, in lexicographic
// order. Balls without room for theirs are marked. Returns the length of the list.
template <bool kExact>
__device__ inline int list_triangles(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                     const DualEdgeMemory& m, BlockBalls& s, int words) {
  const int rows = s.rows, capacity = static_cast<int>(p.capacity.triangles);
  if (threadIdx.x == 0) s.triangles = capacity;
  int all = 0;
  for (int row0 = 0; row0 < rows; row0 += kBlockThreads) {
    const int row = row0 + static_cast<int>(threadIdx.x);
    int b = kMaxBallsPerBlock, j = 0, count = 0, round = 0;
    if (row < rows) b = m.row_ball[row];
    if (b < kMaxBallsPerBlock) {
      j = s.list[b] - s.later[b] + row - s.row0[b];
      for (int w = j >> 5; w < words; ++w)
        count += __popc(m.rows[row * words + w] & bits_after(j, w));
    }
    int at = all + block_scan(count, s.scan, &round);
    all += round;
    if (count == 0) continue;
    if (at + count > capacity) {
      s.exact[b] = 2;
      atomicMin(&s.triangles, at);
      continue;
    }
    for (int w = j >> 5; w < words; ++w) {
      for (std::uint32_t bits = m.rows[row * words + w] & bits_after(j, w); bits != 0;
           bits &= bits - 1) {
        m.triangles[at++] = pack_triangle(row, w * 32 + __ffs(static_cast<int>(bits)) - 1, b);
      }
    }
  }
  if (threadIdx.x == 0 && kExact) note_largest(&out.statistics->most_triangles, all);
  if (threadIdx.x == 0 && !kExact && blockIdx.x % kSampled == 0)
    add(&out.statistics->triangles, all);
  __syncthreads();
  all = min(all, s.triangles);
  // Compaction in place: what a round writes has been read.
  int kept = 0;
  for (int t0 = 0; t0 < all; t0 += kBlockThreads) {
    const int t = t0 + static_cast<int>(threadIdx.x);
    std::uint32_t packed = 0;
    bool keep = false;
    if (t < all) {
      packed = m.triangles[t];
      const Triangle triangle(m, s, words, packed);
      const ScaledNeighbours vector{m.vectors + triangle.entry0};
      keep = triangle.has_fourth(words) &&
             !DualEdge<float>::certainly_outside(vector(triangle.j), vector(triangle.k),
                                                 s.radius_square[triangle.ball]);
    }
    int round = 0;
    const int at = kept + block_scan(keep, s.scan, &round);
    kept += round;
    if (keep) m.triangles[at] = packed;
  }
  __syncthreads();
  return kept;
}

// A warp's next 32 numbers below `end`, or false.
__device__ inline bool take(int* counter, int end, int& mine) {
  int t = 0;
  if ((threadIdx.x & 31) == 0) t = atomicAdd(counter, 32);
  mine = __shfl_sync(~0u, t, 0) + static_cast<int>(threadIdx.x & 31);
  return __any_sync(~0u, mine < end);
}

__device__ inline void note_ends(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                 int b, int t, const TriangleEnds& ends) {
  if (!ends.known) atomicMax(&s.exact[b], 1);
  const int low = min(ends.low, ends.high), high = max(ends.low, ends.high);
  if (high < 0) return;
  const int at = atomicAdd(&s.kept, 1);
  if (at >= static_cast<int>(p.capacity.kept)) {
    s.exact[b] = 2;
    return;
  }
  m.kept[at] = make_uint2(
      t, static_cast<std::uint32_t>(low + 1) | static_cast<std::uint32_t>(high + 1) << 12);
  atomicAdd(&s.tetrahedra[b], low >= 0 ? 2 : 1);
}

// The first few cuts of every triangle: those that survive them are listed. They take about as long
// as each other, whereas lanes that are finished early would wait for them.
__device__ inline void first_cuts(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                  int triangles, int words) {
  for (int t = 0; take(&s.next_triangle, triangles, t);) {
    if (t < triangles) {
      const Triangle triangle(m, s, words, m.triangles[t]);
      const ScaledNeighbours vector{m.vectors + triangle.entry0};
      DualEdge<float> edge;
      bool survives =
          edge.start(vector(triangle.j), vector(triangle.k), s.radius_square[triangle.ball]);
      int left = p.first_cuts;
      for (int w = 0; w < words && survives && left > 0; ++w) {
        std::uint32_t bits = triangle.common(w), first = 0;
        for (; bits != 0 && left > 0; bits &= bits - 1, --left) first |= bits & (0u - bits);
        survives = !clip_by(edge, first, w * 32, vector);
      }
      if (survives) m.work[atomicAdd(&s.survivors, 1)] = static_cast<std::uint16_t>(t);
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel II of the block's triangles.
__device__ inline void find_tetrahedra(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                       BlockBalls& s, int triangles, int words) {
  int count = triangles;
  if (p.first_cuts > 0) {
    first_cuts(p, m, s, triangles, words);
    count = s.survivors;
  } else {
    sort_by_length(m, s, triangles, words);
  }
  for (int at = 0; take(&s.next_work, count, at);) {
    if (at < count) {
      const int t = m.work[at];
      const Triangle triangle(m, s, words, m.triangles[t]);
      note_ends(p, m, s, triangle.ball, t,
                filtered_ends<float>(triangle, words, s.radius_square[triangle.ball],
                                     ScaledNeighbours{m.vectors + triangle.entry0}));
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel III of the block's triangles.
__device__ inline void find_tetrahedra_exactly(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                               BlockBalls& s, int triangles, int words) {
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    const Triangle triangle(m, s, words, m.triangles[t]);
    note_ends(p, m, s, triangle.ball, t, decided_ends(p, m, s.ball[triangle.ball], triangle));
  }
  __syncthreads();
}

// Writes the tetrahedra of all balls but those for kernel III, and where each ball's are.
template <bool kExact>
__device__ inline void write_tetrahedra(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                        const DualEdgeMemory& m, BlockBalls& s, std::uint32_t first,
                                        int balls, int words) {
  if (threadIdx.x < 32) {
    const int b = static_cast<int>(threadIdx.x);
    const int kept = b < balls && !s.exact[b] ? s.tetrahedra[b] : 0;
    // The triangles lie in the order in which half warps were given rows.
    const int row0 = b < balls ? s.row0[b] : 0;
    int before = 0, all = 0;
    for (int o = 0; o < balls; ++o) {
      const int other = __shfl_sync(~0u, kept, o);
      if (__shfl_sync(~0u, row0, o) < row0) before += other;
      all += other;
    }
    if (b == 0) s.base = all == 0 ? 0 : atomicAdd(out.cursor, static_cast<std::uint32_t>(all));
    __syncwarp();
    if (b < balls) {
      if (!kExact && s.exact[b]) {  // all of this ball is done again
        out.exact_list[atomicAdd(out.exact_count, 1u)] = first + b;
        if (s.exact[b] == 2) atomicAdd(&out.statistics->deferred, 1u);
      } else if (!s.exact[b]) {
        out.start[s.index[b]] = s.base + before;
        out.count[s.index[b]] = kept;
      }
    }
    if (kExact && b == 0) note_largest(&out.statistics->most_kept, s.kept);
  }
  __syncthreads();
  const int kept = min(s.kept, static_cast<int>(p.capacity.kept));
  for (int a = threadIdx.x; a < kept; a += kBlockThreads) {
    const uint2 own = m.kept[a];
    const Triangle triangle(m, s, words, m.triangles[own.x]);
    if (s.exact[triangle.ball]) continue;
    std::uint32_t to = s.base;
    for (int o = 0; o < kept; ++o) {
      const uint2 other = m.kept[o];
      if (other.x < own.x && !s.exact[m.triangles[other.x] >> 25])
        to += (other.y & 4095) != 0 ? 2 : 1;
    }
    const int low = static_cast<int>(own.y & 4095) - 1, high = static_cast<int>(own.y >> 12) - 1;
    if (to + (low >= 0 ? 2 : 1) > out.capacity) continue;
    const std::uint32_t* index = m.index + triangle.entry0;
    const uint4 v = make_uint4(s.index[triangle.ball], index[triangle.j], index[triangle.k], 0);
    if (low >= 0) out.tetrahedra[to++] = make_uint4(v.x, v.y, v.z, index[low]);
    out.tetrahedra[to] = make_uint4(v.x, v.y, v.z, index[high]);
  }
}

// Balls [first, first + balls) of the sorted order. Every thread of the block calls it. kWords:
// words of a row, or 0 for any number.
template <bool kExact, int kWords>
__device__ void process_balls(const DualEdgeProblem& p, const SortedBalls& sorted,
                              const DualEdgeOutput& out, const DualEdgeMemory& m, BlockBalls& s,
                              std::uint32_t first, int balls) {
  const int words = kWords > 0 ? kWords : p.words;
  find_lists<kExact>(p, sorted, out, m, s, first, balls);
  for (int row = threadIdx.x; row < s.rows; row += kBlockThreads) {
    const int b = m.row_ball[row];
    if (b == kMaxBallsPerBlock) continue;
    fill_row(p, m, words, s.entry0[b], s.list[b], s.list[b] - s.later[b] + row - s.row0[b],
             s.radius_square[b], m.rows + row * words);
  }
  __syncthreads();
  const int triangles = list_triangles<kExact>(p, out, m, s, words);
  if constexpr (kExact) {
    find_tetrahedra_exactly(p, m, s, triangles, words);
  } else {
    find_tetrahedra(p, m, s, triangles, words);
  }
  write_tetrahedra<kExact>(p, out, m, s, first, balls, words);
}

template <int kWords>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_filtered(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(shared, p);
  const std::uint32_t alive = *sorted.alive;
  const std::uint32_t first = blockIdx.x * static_cast<std::uint32_t>(p.common.balls_per_block);
  if (first >= alive) return;
  const int balls =
      static_cast<int>(min(static_cast<std::uint32_t>(p.common.balls_per_block), alive - first));
  process_balls<false, kWords>(p, sorted, out, m, s, first, balls);
}

// One ball at a time; p.common.balls_per_block is 1.
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_exact(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  extern __shared__ __align__(16) unsigned char shared[];
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(shared, p);
  const std::uint32_t count = *out.exact_count;
  if (out.statistics->deferred > p.deferred_limit) return;
  for (std::uint32_t n = blockIdx.x; n < count; n += gridDim.x) {
    process_balls<true, 0>(p, sorted, out, m, s, out.exact_list[n], 1);
    __syncthreads();
  }
}

}  // namespace alphascope::gpu
