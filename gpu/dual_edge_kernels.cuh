// The CUDA executor of the facet engine: one block takes a run of balls through neighbours (kernel
// I: lists, which neighbours meet, triangles ijk worth a look) and dual edges in single precision
// with certified errors (kernel II), and writes the simplices whose lowest vertex is one of its
// balls. A ball with an undecided simplex goes, whole, to the same kernel with double precision and
// exact integers (kernel III). The bodies per triangle and edge are core/complex/triangle_faces.hpp
// and facet_disc.hpp.
#pragma once

#include "gpu/dual_edge_output.cuh"
#include "gpu/dual_edge_rows.cuh"
#include "gpu/launch.cuh"

namespace alphascope::gpu {

// Kernel III of one triangle: double precision, then integers. Not inlined: it is rare and large.
__device__ __noinline__ TriangleFace decided_face(const DualEdgeProblem& p,
                                                  const ExactNeighbours& neighbours,
                                                  const TriangleRows& t) {
  const TriangleFace face =
      filtered_face<double>(t, p.words, static_cast<double>(neighbours.weight()) + p.common.alpha,
                            [&](int a) { return lifted_as<double>(neighbours.lifted(a)); });
  if (face.in != Decision::unknown) return face;
  const auto in = neighbours.of(p);
  return p.small_lattice ? exact_face<Int128>(in, t, p.words)
                         : exact_face<WideInt<4>>(in, t, p.words);
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
  for (int w = threadIdx.x; w < balls * p.words; w += kBlockThreads) m.possible[w] = 0;
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
    }
    const bool lane_attached = active && room && order_list(p.common, sorted, m, centre, n, entry0);
    const bool attached = (__ballot_sync(~0u, lane_attached) >> half & 0xffffu) != 0;
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
      s.attached[b] = attached;
      s.first_triangle[b] = INT_MAX;
      s.end_triangle[b] = 0;
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

// The list of triangles of three balls that meet, whose edges ij and ik are possible and which, of
// tetrahedra alone, have a fourth: of each ball, in lexicographic order. Balls without room for
// theirs are marked. Returns the length of the list.
template <bool kWhole, bool kExact>
__device__ inline int list_triangles(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                     const DualEdgeMemory& m, BlockBalls& s, int words) {
  const int rows = s.rows, capacity = static_cast<int>(p.capacity.triangles);
  const auto later_bits = [&](int row, int w, int j, int b) {
    const std::uint32_t bits = m.rows[row * words + w] & bits_after(j, w);
    return looks_at_edges<kWhole>(p) ? bits & m.possible[b * words + w] : bits;
  };
  if (threadIdx.x == 0) s.triangles = capacity;
  int all = 0;
  for (int row0 = 0; row0 < rows; row0 += kBlockThreads) {
    const int row = row0 + static_cast<int>(threadIdx.x);
    int b = kMaxBallsPerBlock, j = 0, count = 0, round = 0;
    if (row < rows) b = m.row_ball[row] & kRowBall;
    if (b < kMaxBallsPerBlock) {
      j = s.list[b] - s.later[b] + row - s.row0[b];
      for (int w = j >> 5; w < words; ++w) count += __popc(later_bits(row, w, j, b));
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
      for (std::uint32_t bits = later_bits(row, w, j, b); bits != 0; bits &= bits - 1) {
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
      keep = (kWhole || triangle.has_fourth(words)) &&
             !DualEdge<float>::certainly_outside(vector(triangle.j), vector(triangle.k),
                                                 s.radius_square[triangle.ball]);
    }
    int round = 0;
    const int at = kept + block_scan(keep, s.scan, &round);
    kept += round;
    if (keep) m.triangles[at] = packed;
  }
  __syncthreads();
  for (int t = threadIdx.x; t < kept; t += kBlockThreads) {
    const std::uint32_t b = m.triangles[t] >> 25;
    if (t == 0 || m.triangles[t - 1] >> 25 != b) s.first_triangle[b] = t;
    if (t + 1 == kept || m.triangles[t + 1] >> 25 != b) s.end_triangle[b] = t + 1;
  }
  for (int w = threadIdx.x; w <= kept >> 5; w += kBlockThreads)
    m.found_bits[w] = m.one_bits[w] = m.two_bits[w] = 0;
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

// Keeps a triangle of K_alpha; of tetrahedra alone, one with tetrahedra to write.
__device__ inline void keep(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s, int b,
                            int t, int tetrahedra, const TriangleFace& face) {
  const int at = atomicAdd(&s.kept, 1);
  if (at >= static_cast<int>(p.capacity.kept)) {
    s.exact[b] = 2;
    return;
  }
  m.kept[at] = make_uint2(t, pack_face(face));
  const std::uint32_t bit = 1u << (t & 31);
  if (p.common.whole) atomicOr(&m.found_bits[t >> 5], bit);
  if (tetrahedra > 0) atomicOr(&m.one_bits[t >> 5], bit);
  if (tetrahedra > 1) atomicOr(&m.two_bits[t >> 5], bit);
}

template <bool kWhole>
__device__ inline void note_face(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                 const Triangle& t, int number, const TriangleFace& face) {
  if (face.in == Decision::unknown) {
    atomicMax(&s.exact[t.ball], 1);
    return;
  }
  const int tetrahedra = (face.high > t.k) + (face.low > t.k);
  if (face.in == Decision::in && (kWhole || tetrahedra > 0))
    keep(p, m, s, t.ball, number, tetrahedra, face);
}

// The answer of a run for tetrahedra alone.
__device__ inline TriangleFace as_face(const TriangleEnds& ends) {
  return {ends.known ? Decision::in : Decision::unknown, ends.high, ends.low,
          TriangleFace::Attached::no};
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
      const bool survives =
          edge.start(vector(triangle.j), vector(triangle.k), s.radius_square[triangle.ball]) &&
          !clips_away(edge, triangle, words, p.first_cuts, vector);
      if (survives) m.work[atomicAdd(&s.survivors, 1)] = static_cast<std::uint16_t>(t);
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel II of the block's triangles.
template <bool kWhole>
__device__ inline void find_faces(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                  int triangles, int words) {
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
      const float square = s.radius_square[triangle.ball];
      const ScaledNeighbours vectors{m.vectors + triangle.entry0};
      if constexpr (kWhole) {
        note_face<true>(p, m, s, triangle, t,
                        filtered_face<float>(triangle, words, square, vectors));
      } else {
        note_face<false>(p, m, s, triangle, t,
                         as_face(filtered_ends<float>(triangle, words, square, vectors)));
      }
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel III of the block's triangles.
template <bool kWhole>
__device__ inline void find_faces_exactly(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                          BlockBalls& s, int triangles, int words) {
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    const Triangle triangle(m, s, words, m.triangles[t]);
    note_face<kWhole>(p, m, s, triangle, t,
                      decided_face(p, exact_neighbours(p, m, s, triangle.ball), triangle));
  }
  __syncthreads();
}

// Per ball: is it a vertex of K_alpha?
__device__ inline void write_vertex_states(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                           const BlockBalls& s, int balls) {
  const int b = static_cast<int>(threadIdx.x);
  if (b >= balls || s.exact[b]) return;
  const double weight = static_cast<double>(static_cast<std::int64_t>(s.ball[b].w) * s.ball[b].w);
  // Equality counts as attached (see BallSimplices::vertex_state).
  out.vertex_state[s.index[b]] = -weight > p.common.alpha ? 0 : s.attached[b] ? 1 : 2;
}

// Balls [first, first + balls) of the sorted order. Every thread of the block calls it. kWords:
// words of a row, or 0 for any number.
template <bool kWhole, bool kExact, int kWords>
__device__ void process_balls(const DualEdgeProblem& p, const SortedBalls& sorted,
                              const DualEdgeOutput& out, const DualEdgeMemory& m, BlockBalls& s,
                              std::uint32_t first, int balls) {
  const int words = kWords > 0 ? kWords : p.words;
  find_lists<kExact>(p, sorted, out, m, s, first, balls);
  make_rows<kWhole, kExact>(p, m, s, words);
  const int triangles = list_triangles<kWhole, kExact>(p, out, m, s, words);
  if constexpr (kExact) {
    find_faces_exactly<kWhole>(p, m, s, triangles, words);
  } else {
    find_faces<kWhole>(p, m, s, triangles, words);
  }
  if constexpr (kWhole) write_vertex_states(p, out, s, balls);
  write_simplices<kWhole, kExact>(p, out, m, s, first, balls, triangles, words);
}

template <bool kWhole, int kWords>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_filtered(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(dynamic_shared_memory(), p);
  const std::uint32_t alive = *sorted.alive;
  const std::uint32_t first = blockIdx.x * static_cast<std::uint32_t>(p.common.balls_per_block);
  if (first >= alive) return;
  const int balls =
      static_cast<int>(min(static_cast<std::uint32_t>(p.common.balls_per_block), alive - first));
  process_balls<kWhole, false, kWords>(p, sorted, out, m, s, first, balls);
}

// One ball at a time; p.common.balls_per_block is 1.
template <bool kWhole>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_exact(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(dynamic_shared_memory(), p);
  const std::uint32_t count = *out.exact_count;
  if (out.statistics->deferred > p.deferred_limit) return;
  for (std::uint32_t n = blockIdx.x; n < count; n += gridDim.x) {
    process_balls<kWhole, true, 0>(p, sorted, out, m, s, out.exact_list[n], 1);
    __syncthreads();
  }
}

}  // namespace alphascope::gpu
