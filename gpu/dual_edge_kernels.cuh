// The CUDA executor of the facet engine: one block takes a run of balls through neighbours (kernel
// I: lists, which neighbours meet, triangles ijk worth a look) and dual edges in single precision
// with certified errors (kernel II), and writes the simplices whose lowest vertex is one of its
// balls. A ball with an undecided simplex goes, whole, to the same kernel with double precision and
// exact integers (kernel III). The bodies per triangle and edge are core/complex/triangle_faces.hpp
// and facet_disc.hpp.
#pragma once

#include "core/complex/dual_edge_probe.hpp"
#include "gpu/dual_edge_lists.cuh"
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
template <class Kind>
__device__ inline int list_triangles(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                     const DualEdgeMemory& m, BlockBalls& s, int words) {
  const int rows = s.rows, capacity = static_cast<int>(p.capacity.triangles);
  const auto later_bits = [&](int row, int w, int j, int b) {
    const std::uint32_t bits = m.rows[row * words + w] & bits_after(j, w);
    return Kind::kEdges ? bits & m.possible[b * words + w] : bits;
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
  if (threadIdx.x == 0 && Kind::kExact) note_largest(&out.statistics->most_triangles, all);
  if (threadIdx.x == 0 && !Kind::kExact && blockIdx.x % kSampled == 0)
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
      keep = (Kind::kWhole || triangle.has_fourth(words)) &&
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

template <class Kind>
__device__ inline void note_face(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                 const Triangle& t, int number, const TriangleFace& face) {
  if (face.in == Decision::unknown) {
    atomicMax(&s.exact[t.ball], 1);
    return;
  }
  const int tetrahedra = (face.high > t.k) + (face.low > t.k);
  if (face.in == Decision::in && (Kind::kWhole || tetrahedra > 0))
    keep(p, m, s, t.ball, number, tetrahedra, face);
}

// Kernel II of one triangle.
template <class Kind, class Rows>
__device__ inline TriangleFace found_face(const DualEdgeMemory& m, const BlockBalls& s,
                                          const Triangle& t, const Rows& rows, int words) {
  const float square = s.radius_square[t.ball];
  const ScaledNeighbours vectors{m.vectors + t.entry0};
  if constexpr (Kind::kWhole) {
    return filtered_face<float>(rows, words, square, vectors);
  } else {
    const TriangleEnds ends = filtered_ends<float>(rows, words, square, vectors);
    return {ends.known ? Decision::in : Decision::unknown, ends.high, ends.low,
            TriangleFace::Attached::no};
  }
}

// Do the cuts by these neighbours certainly leave nothing?
template <class Cutters>
__device__ inline bool probed_away(const DualEdge<float>& edge, int words, const Cutters& cutters,
                                   const ScaledNeighbours& vector) {
  // Of balls that meet: |d| is at most 1 and a few roundings, and so is c less a quarter.
  DualEdgeProbe<float> probe(edge, 1.75f, 2);
  for (int w = 0; w < words; ++w) {
    for (std::uint32_t bits = cutters(w); bits != 0; bits &= bits - 1) {
      if (probe.clip(vector(w * 32 + lowest_bit(bits)))) return true;
    }
  }
  return false;
}

// The likeliest cuts of every triangle: those that survive them are listed. They take about as long
// as each other, whereas lanes that are finished early would wait for them.
__device__ inline void first_cuts(const DualEdgeMemory& m, BlockBalls& s, int triangles,
                                  int words) {
  for (int t = 0; take(&s.next_triangle, triangles, t);) {
    if (t < triangles) {
      const Triangle triangle(m, s, words, m.triangles[t]);
      const ScaledNeighbours vector{m.vectors + triangle.entry0};
      const std::uint32_t* near = m.near + triangle.ball * words;
      DualEdge<float> edge;
      if (edge.start(vector(triangle.j), vector(triangle.k), s.radius_square[triangle.ball]) &&
          !probed_away(
              edge, words, [&](int w) { return triangle.common(w) & near[w]; }, vector))
        m.work[atomicAdd(&s.survivors, 1)] = static_cast<std::uint16_t>(t);
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel II of the block's triangles.
template <class Kind>
__device__ inline void find_faces(const DualEdgeProblem& p, const DualEdgeMemory& m, BlockBalls& s,
                                  int triangles, int words) {
  int count = triangles;
  if constexpr (Kind::kCull) {
    first_cuts(m, s, triangles, words);
    count = s.survivors;
  } else {
    sort_by_length(m, s, triangles, words);
  }
  for (int at = 0; take(&s.next_work, count, at);) {
    if (at < count) {
      const int t = m.work[at];
      const Triangle triangle(m, s, words, m.triangles[t]);
      if constexpr (Kind::kCull) {
        const std::uint32_t* near = m.near + triangle.ball * words;
        note_face<Kind>(p, m, s, triangle, t,
                        found_face<Kind>(m, s, triangle, NearFirstRows{triangle, near}, words));
      } else {
        note_face<Kind>(p, m, s, triangle, t,
                        found_face<Kind>(m, s, triangle, TriangleRows{triangle}, words));
      }
    }
    __syncwarp();
  }
  __syncthreads();
}

// Kernel III of the block's triangles: single precision once more, which spares most of them, and
// the rest for certain.
template <class Kind>
__device__ inline void find_faces_exactly(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                          BlockBalls& s, int triangles, int words) {
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    const Triangle triangle(m, s, words, m.triangles[t]);
    const std::uint32_t* near = m.near + triangle.ball * words;
    TriangleFace face = found_face<Kind>(m, s, triangle, NearFirstRows{triangle, near}, words);
    if (face.in == Decision::unknown)
      face = decided_face(p, exact_neighbours(p, m, s, triangle.ball), triangle);
    note_face<Kind>(p, m, s, triangle, t, face);
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
template <class Kind, int kWords>
__device__ void process_balls(const DualEdgeProblem& p, const SortedBalls& sorted,
                              const DualEdgeOutput& out, const DualEdgeMemory& m, BlockBalls& s,
                              std::uint32_t first, int balls) {
  const int words = kWords > 0 ? kWords : p.words;
  find_lists<Kind>(p, sorted, out, m, s, first, balls);
  make_rows<Kind>(p, m, s, words);
  const int triangles = list_triangles<Kind>(p, out, m, s, words);
  if constexpr (Kind::kExact) {
    find_faces_exactly<Kind>(p, m, s, triangles, words);
  } else {
    find_faces<Kind>(p, m, s, triangles, words);
  }
  if constexpr (Kind::kWhole) write_vertex_states(p, out, s, balls);
  write_simplices<Kind>(p, out, m, s, first, balls, triangles, words);
}

template <bool kWhole, bool kCull, int kWords>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_filtered(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(dynamic_shared_memory(), p);
  const std::uint32_t alive = *sorted.alive;
  const std::uint32_t first = blockIdx.x * static_cast<std::uint32_t>(p.common.balls_per_block);
  if (first >= alive) return;
  const int balls =
      static_cast<int>(min(static_cast<std::uint32_t>(p.common.balls_per_block), alive - first));
  process_balls<KernelKind<kWhole, false, kCull>, kWords>(p, sorted, out, m, s, first, balls);
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
    process_balls<KernelKind<kWhole, true, true>, 0>(p, sorted, out, m, s, out.exact_list[n], 1);
    __syncthreads();
  }
}

}  // namespace alphascope::gpu
