// SPDX-License-Identifier: GPL-3.0-or-later
// The CUDA executor of the dual-edge engine. A block takes a run of balls through kernel I: lists,
// neighbours that meet, candidate triangles ijk. Then kernel II clips dual edges in single
// precision with certified errors. The block writes the simplices whose lowest vertex is one of its
// balls. A ball with an undecided simplex goes as a whole to kernel III. That is the same code with
// double precision and exact integers. The bodies for triangles and edges are
// core/dual_edge/triangle_faces.hpp and facet_disc.hpp.
#pragma once

#include "core/dual_edge/dual_edge_probe.hpp"
#include "gpu/dual_edge/dual_edge_lists.cuh"
#include "gpu/dual_edge/dual_edge_output.cuh"
#include "gpu/dual_edge/dual_edge_rows.cuh"
#include "gpu/memory/launch.cuh"

namespace alphascope::gpu {

// Kernel III of one triangle: double precision, then integers. Not inlined, because it is rare and
// large.
__device__ __noinline__ TriangleFace decided_face(const DualEdgeProblem& p,
                                                  const ExactNeighbours& neighbours,
                                                  const TriangleRows& t) {
  const TriangleFace face =
      filtered_face<double>(t, p.words, p.common.alpha.plus(neighbours.weight()),
                            [&](int a) { return lifted_as<double>(neighbours.lifted(a)); });
  if (face.in != Decision::unknown) return face;
  const auto in = neighbours.of(p);
  return p.small_lattice ? exact_face<Int128>(in, t, p.words)
                         : exact_face<WideInt<4>>(in, t, p.words);
}

// Lists the triangles of three balls that meet and whose edges ij and ik are possible. The
// triangles of each ball are in lexicographic order. Balls without room for theirs are marked.
// Returns the length of the list.
template <class Kind>
__device__ inline int list_triangles(const Block& block) {
  const DualEdgeProblem& p = block.p;
  const DualEdgeOutput& out = block.out;
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  const int words = block.words;
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
    if (b == kMaxBallsPerBlock) continue;
    if (row == s.row0[b]) s.first_triangle[b] = at;
    if (row + 1 == s.row0[b] + s.later[b]) s.end_triangle[b] = at + count;
    if (count != 0 && at + count > capacity) {
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
  if (threadIdx.x == 0 && !Kind::kExact && is_sampled(p)) measure(out.statistics->triangles, all);
  __syncthreads();
  all = min(all, s.triangles);
  for (int w = threadIdx.x; w <= all >> 5; w += kBlockThreads)
    m.found_bits[w] = m.one_bits[w] = m.two_bits[w] = 0;
  return all;
}

// Returns whether the triangle's line can be within alpha. For tetrahedra alone there must also be
// a fourth ball.
template <class Kind>
__device__ inline bool is_candidate(const Block& block, const Triangle& triangle) {
  const ScaledNeighbours vector{block.m.vectors + triangle.entry0};
  return (Kind::kWhole || triangle.has_fourth(block.words)) &&
         !DualEdge<float>::certainly_outside(vector(triangle.j), vector(triangle.k),
                                             block.s.radius_square[triangle.ball]);
}

// A list of triangle numbers, and the number for which it has room.
struct TriangleList {
  std::uint16_t* numbers;
  std::uint32_t room;
};
// Puts triangle t of ball b on a list. If that has no room, the ball goes to kernel III.
__device__ inline void add_to_list(const TriangleList& list, BlockBalls& s, int place, int t,
                                   int b) {
  if (place < static_cast<int>(list.room)) {
    list.numbers[place] = static_cast<std::uint16_t>(t);
  } else {
    s.exact[b] = 2;
  }
}

// Lists the candidates, in any order. Every thread must call it. Returns the length of the list.
template <class Kind>
__device__ inline int list_candidates(const Block& block, int triangles) {
  const BlockRoom& room = block.p.capacity;
  BlockBalls& s = block.s;
  const int lane = threadIdx.x & 31;
  for (int t0 = threadIdx.x - lane; t0 < triangles; t0 += kBlockThreads) {
    const int t = t0 + lane;
    int ball = 0;
    bool keep = false;
    if (t < triangles) {
      const Triangle triangle(block, t);
      ball = triangle.ball;
      keep = is_candidate<Kind>(block, triangle);
    }
    const unsigned votes = __ballot_sync(~0u, keep);
    int base = 0;
    if (lane == 0) base = atomicAdd(&s.listed, __popc(votes));
    base = __shfl_sync(~0u, base, 0);
    const int place = base + __popc(votes & ((1u << lane) - 1));
    if (keep) add_to_list({block.m.listed, room.listed}, s, place, t, ball);
  }
  __syncthreads();
  return min(s.listed, static_cast<int>(room.listed));
}

// Lists the candidates by falling number of cuts (a counting sort). So the lanes of a warp take
// about equally long.
template <class Kind>
__device__ inline int sort_candidates(const Block& block, int triangles) {
  const BlockRoom& room = block.p.capacity;
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    const Triangle triangle(block, t);
    int length = kLengths;  // no candidate
    if (is_candidate<Kind>(block, triangle)) {
      int cuts = 0;
      for (int w = 0; w < block.words; ++w) cuts += __popc(triangle.common(w));
      length = kLengths - 1 - min(cuts, kLengths - 1);
      atomicAdd(&s.lengths[length], 1);
    }
    m.length[t] = static_cast<std::uint8_t>(length);
  }
  __syncthreads();
  if (threadIdx.x < kLengths) {
    const int own = s.lengths[threadIdx.x], before = warp_scan(own);
    s.lengths[threadIdx.x] = before;
    if (threadIdx.x == kLengths - 1) s.listed = before + own;
  }
  __syncthreads();
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    if (m.length[t] >= kLengths) continue;
    const int place = atomicAdd(&s.lengths[m.length[t]], 1);
    add_to_list({m.listed, room.listed}, s, place, t, m.triangles[t] >> 25);
  }
  __syncthreads();
  return min(s.listed, static_cast<int>(room.listed));
}

// Takes the next 32 numbers below `end` for a warp. Returns false if there are none.
__device__ inline bool take(int* counter, int end, int& mine) {
  int t = 0;
  if ((threadIdx.x & 31) == 0) t = atomicAdd(counter, 32);
  mine = __shfl_sync(~0u, t, 0) + static_cast<int>(threadIdx.x & 31);
  return __any_sync(~0u, mine < end);
}

// Keeps a triangle of K_alpha. For tetrahedra alone, it must have tetrahedra to write.
__device__ inline void keep(const Block& block, int b, int t, int tetrahedra,
                            const TriangleFace& face) {
  const DualEdgeMemory& m = block.m;
  const int at = atomicAdd(&block.s.kept, 1);
  if (at >= static_cast<int>(block.p.capacity.kept)) {
    block.s.exact[b] = 2;
    return;
  }
  m.kept[at] = make_uint2(t, pack_face(face));
  const std::uint32_t bit = 1u << (t & 31);
  if (block.p.common.whole) atomicOr(&m.found_bits[t >> 5], bit);
  if (tetrahedra > 0) atomicOr(&m.one_bits[t >> 5], bit);
  if (tetrahedra > 1) atomicOr(&m.two_bits[t >> 5], bit);
}

// The rows of balls that clip a triangle's dual edge.
template <class Kind>
__device__ inline auto rows_of(const Block& block, const Triangle& t) {
  if constexpr (Kind::kCull) {
    return NearFirstRows{t, block.m.near + t.ball * block.words};
  } else {
    return TriangleRows{t};
  }
}

template <class Kind>
__device__ inline void note_face(const Block& block, const Triangle& t, int number,
                                 const TriangleFace& face) {
  if (face.in == Decision::unknown) {
    atomicMax(&block.s.exact[t.ball], 1);
    return;
  }
  const int tetrahedra = (face.high > t.k) + (face.low > t.k);
  if (face.in == Decision::in && (Kind::kWhole || tetrahedra > 0))
    keep(block, t.ball, number, tetrahedra, face);
}

// Kernel II of one triangle.
template <class Kind>
__device__ inline TriangleFace found_face(const Block& block, const Triangle& t) {
  const auto rows = rows_of<Kind>(block, t);
  const float square = block.s.radius_square[t.ball];
  const ScaledNeighbours vectors{block.m.vectors + t.entry0};
  if constexpr (Kind::kWhole) {
    return filtered_face<float>(rows, block.words, square, vectors);
  } else {
    const TriangleEnds ends = filtered_ends<float>(rows, block.words, square, vectors);
    return {ends.known ? Decision::in : Decision::unknown, ends.high, ends.low,
            TriangleFace::Attached::no};
  }
}

// Returns whether the cuts by these neighbours certainly leave nothing.
template <class Cutters>
__device__ inline bool probed_away(const DualEdge<float>& edge, int words, const Cutters& cutters,
                                   const ScaledNeighbours& vector) {
  // For balls that meet, |d| and c - 1/4 are at most 1 plus a few roundings.
  DualEdgeProbe<float> probe(edge, 1.75f, 2);
  for (int w = 0; w < words; ++w) {
    for (std::uint32_t bits = cutters(w); bits != 0; bits &= bits - 1) {
      if (probe.clip(vector(w * 32 + lowest_bit(bits)))) return true;
    }
  }
  return false;
}

// Most triangles have no dual edge. For culled lists, only the likeliest cuts are tried first, and
// ends are not computed. Often these cuts certainly leave nothing. This test takes about the same
// time in all lanes of a warp, and the remaining triangles then fill whole warps. Returns the
// number of remaining triangles.
__device__ inline int probe_triangles(const Block& block, int listed) {
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  const int words = block.words;
  for (int at = 0; take(&s.next_listed, listed, at);) {
    if (at < listed) {
      const int t = m.listed[at];
      const Triangle triangle(block, t);
      const ScaledNeighbours vector{m.vectors + triangle.entry0};
      const std::uint32_t* near = m.near + triangle.ball * words;
      DualEdge<float> edge;
      if (edge.start(vector(triangle.j), vector(triangle.k), s.radius_square[triangle.ball]) &&
          !probed_away(
              edge, words, [&](int w) { return triangle.common(w) & near[w]; }, vector))
        add_to_list({m.probed, block.p.capacity.probed}, s, atomicAdd(&s.probed, 1), t,
                    triangle.ball);
    }
    __syncwarp();
  }
  __syncthreads();
  return min(s.probed, static_cast<int>(block.p.capacity.probed));
}

// Kernel II of the block's triangles.
template <class Kind>
__device__ inline void find_faces(const Block& block, int triangles) {
  BlockBalls& s = block.s;
  int count = 0;
  const std::uint16_t* left = block.m.listed;
  if constexpr (Kind::kCull) {
    count = probe_triangles(block, list_candidates<Kind>(block, triangles));
    left = block.m.probed;
  } else {
    count = sort_candidates<Kind>(block, triangles);
  }
  for (int at = 0; take(&s.next_work, count, at);) {
    if (at < count) {
      const int t = left[at];
      const Triangle triangle(block, t);
      note_face<Kind>(block, triangle, t, found_face<Kind>(block, triangle));
    }
    __syncwarp();
  }
  __syncthreads();
  if (threadIdx.x == 0 && is_sampled(block.p)) {
    BlockStatistics& met = *block.out.statistics;
    measure(met.listed, s.listed);
    if (Kind::kCull) measure(met.probed, s.probed);
    measure(met.kept, s.kept);
  }
}

// Kernel III of the block's triangles. Single precision is tried once more and decides most of
// them. The rest is decided exactly.
template <class Kind>
__device__ inline void find_faces_exactly(const Block& block, int triangles) {
  __syncthreads();
  for (int t = threadIdx.x; t < triangles; t += kBlockThreads) {
    const Triangle triangle(block, t);
    if (!is_candidate<Kind>(block, triangle)) continue;
    TriangleFace face = found_face<Kind>(block, triangle);
    if (face.in == Decision::unknown)
      face = decided_face(block.p, exact_neighbours(block, triangle.ball), triangle);
    note_face<Kind>(block, triangle, t, face);
  }
  __syncthreads();
}

// Writes for each ball whether it is a vertex of K_alpha.
__device__ inline void write_vertex_states(const Block& block) {
  const BlockBalls& s = block.s;
  const int b = static_cast<int>(threadIdx.x);
  if (b >= block.balls || s.exact[b]) return;
  const std::int64_t weight = static_cast<std::int64_t>(s.ball[b].w) * s.ball[b].w;
  // Equal power counts as attached (see BallSimplices::vertex_state).
  block.out.vertex_state[s.index[b]] = block.p.common.alpha.plus(weight) < 0 ? 0 : s.state[b];
}

// Processes the block's balls. Every thread of the block must call it.
template <class Kind>
__device__ void process_balls(const Block& block, const SortedBalls& sorted) {
  find_lists<Kind>(block, sorted);
  make_rows<Kind>(block);
  const int triangles = list_triangles<Kind>(block);
  if constexpr (Kind::kExact) {
    find_faces_exactly<Kind>(block, triangles);
  } else {
    find_faces<Kind>(block, triangles);
  }
  if constexpr (Kind::kWhole) write_vertex_states(block);
  write_simplices<Kind>(block, triangles);
}

// kWords: length of a row, or 0 for any length.
template <bool kWhole, bool kCull, int kWords>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_filtered(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(dynamic_shared_memory(), p);
  const std::uint32_t first = p.begin + blockIdx.x * p.common.balls_per_block;
  const int balls =
      static_cast<int>(min(static_cast<std::uint32_t>(p.common.balls_per_block), p.end - first));
  constexpr bool kAny = kWords == 0;
  process_balls<KernelKind<kWhole, false, kCull>>(
      {p, out, m, s, kAny ? p.words : kWords, first, balls}, sorted);
}

// Processes one ball at a time; p.common.balls_per_block must be 1.
template <bool kWhole>
__global__ void __launch_bounds__(kBlockThreads)
    dual_edges_exact(DualEdgeProblem p, SortedBalls sorted, DualEdgeOutput out) {
  __shared__ BlockBalls s;
  const DualEdgeMemory m = carve(dynamic_shared_memory(), p);
  const std::uint32_t count = *out.exact_count;
  // Kernel II of the next chunk may still add to `deferred`, so the block's threads have to agree
  // on it.
  if (__syncthreads_or(out.statistics->deferred > p.deferred_limit)) return;
  for (std::uint32_t n = blockIdx.x; n < count; n += gridDim.x) {
    process_balls<KernelKind<kWhole, true, true>>({p, out, m, s, p.words, out.exact_list[n], 1},
                                                  sorted);
    __syncthreads();
  }
}

}  // namespace alphascope::gpu
