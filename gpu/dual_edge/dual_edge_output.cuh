// SPDX-License-Identifier: GPL-3.0-or-later
// The order and places of the simplices that a block writes, from the triangles that it found.
#pragma once

#include <climits>

#include "core/complex/face_class.hpp"
#include "core/geometry/ordered_bits.hpp"
#include "gpu/dual_edge/dual_edge_block.cuh"

namespace alphascope::gpu {

// Number of found triangles, and of tetrahedra, before triangle t of the block.
__device__ inline std::uint32_t triangles_before(const DualEdgeMemory& m, int t) {
  const std::uint32_t below = (1u << (t & 31)) - 1;
  return m.triangles_before[t >> 5] + __popc(m.found_bits[t >> 5] & below);
}
__device__ inline std::uint32_t tetrahedra_before(const DualEdgeMemory& m, int t) {
  const std::uint32_t below = (1u << (t & 31)) - 1;
  return m.tetrahedra_before[t >> 5] + __popc(m.one_bits[t >> 5] & below) +
         __popc(m.two_bits[t >> 5] & below);
}

// Sets for each word of `triangles` the sum of `bits(w)` over the words before. Called by one warp.
template <class Bits>
__device__ inline void sum_before(int triangles, std::uint32_t* before, const Bits& bits) {
  const int words = (triangles >> 5) + 1;
  int sum = 0;
  for (int w0 = 0; w0 < words; w0 += 32) {
    const int w = w0 + static_cast<int>(threadIdx.x & 31);
    const int own = w < words ? bits(w) : 0, scanned = warp_scan(own);
    if (w < words) before[w] = sum + scanned;
    sum += __shfl_sync(~0u, scanned + own, 31);
  }
}

// Reserves room for the simplices of each lane's ball. Called by one warp. `lane` makes the request
// for all; different lanes allow several requests to run at once.
class OutputRange {
 public:
  __device__ OutputRange(int own, std::uint32_t* cursor, int lane)
      : before_(warp_scan(own)), lane_(lane), base_(0) {
    const int all = __shfl_sync(~0u, before_ + own, 31);
    if (static_cast<int>(threadIdx.x & 31) == lane && all != 0) base_ = atomicAdd(cursor, all);
  }
  __device__ std::uint32_t start() const { return __shfl_sync(~0u, base_, lane_) + before_; }

 private:
  int before_, lane_;
  std::uint32_t base_;
};

// Reserves places for the simplices of each ball. Balls for kernel III are listed instead. Called
// by one warp.
template <class Kind>
__device__ inline void reserve_output(const Block& block) {
  const DualEdgeOutput& out = block.out;
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  const int b = static_cast<int>(threadIdx.x);
  const bool mine = b < block.balls && !s.exact[b];
  const int begin = mine ? s.first_triangle[b] : 0, end = mine ? s.end_triangle[b] : 0;
  const std::uint32_t index = mine ? s.index[b] : 0;
  const bool any = begin < end;
  const std::uint32_t tetrahedron0 = any ? tetrahedra_before(m, begin) : 0,
                      tetrahedra = any ? tetrahedra_before(m, end) - tetrahedron0 : 0;
  const OutputRange tetrahedron(static_cast<int>(tetrahedra), out.tetrahedra.cursor, 0);
  if constexpr (Kind::kWhole) {
    const std::uint32_t triangle0 = any ? triangles_before(m, begin) : 0,
                        triangles = any ? triangles_before(m, end) - triangle0 : 0;
    const int edges = mine ? s.later[b] : 0;
    const OutputRange triangle(static_cast<int>(triangles), out.triangles.cursor, 1);
    const OutputRange edge(edges, out.edges.cursor, 2);
    const std::uint32_t triangle_start = triangle.start(), edge_start = edge.start();
    if (mine) {
      out.triangles.start[index] = triangle_start;
      out.triangles.count[index] = triangles;
      s.triangle_at[b] = triangle_start - triangle0;
      out.edges.start[index] = edge_start;
      out.edges.count[index] = edges;
      s.edge_at[b] = edge_start - s.row0[b];
    }
  }
  const std::uint32_t start = tetrahedron.start();
  if (mine) {
    out.tetrahedra.start[index] = start;
    out.tetrahedra.count[index] = tetrahedra;
    s.tetrahedron_at[b] = start - tetrahedron0;
  }
  if (!Kind::kExact && b < block.balls && s.exact[b]) {  // kernel III computes this ball anew
    out.exact_list[atomicAdd(out.exact_count, 1u)] = block.first + b;
    if (s.exact[b] == 2) atomicAdd(&out.statistics->deferred, 1u);
  }
  if (Kind::kExact && b == 0) note_largest(&out.statistics->most_kept, s.kept);
}

__device__ inline void write_edges(const EdgeCandidates& out, const DualEdgeMemory& m,
                                   const BlockBalls& s) {
  for (int row = threadIdx.x; row < s.rows; row += kBlockThreads) {
    const int owner = m.row_ball[row], b = owner & kRowBall;
    if (b == kMaxBallsPerBlock || s.exact[b]) continue;
    const std::uint32_t to = s.edge_at[b] + row;
    if (to >= out.capacity) continue;
    const int j = s.list[b] - s.later[b] + row - s.row0[b];
    out.end[to] = m.index[s.entry0[b] + j];
    out.least[to] = kNoValue;
    out.flags[to] = owner & kUnattachedRow ? kUnattached : 0;
  }
}

__device__ inline void write_triangle(const FoundTriangles& out, std::uint32_t to, uint3 ijk,
                                      std::uint32_t info, std::uint32_t attached_to) {
  if (to >= out.capacity) return;
  std::uint32_t* v = out.vertices + 3 * static_cast<std::size_t>(to);
  v[0] = ijk.x;
  v[1] = ijk.y;
  v[2] = ijk.z;
  out.info[to] = info;
  out.attached_to[to] = attached_to;
}

// The ball that ends the dual edge on the side to which the triangle is attached.
__device__ inline std::uint32_t attached_ball(const TriangleFace& f, const std::uint32_t* index) {
  using Attached = TriangleFace::Attached;
  return f.attached == Attached::no ? kNoBall
                                    : index[f.attached == Attached::high ? f.high : f.low];
}

// Writes the simplices of all balls but those for kernel III, and the places of each ball's
// simplices.
template <class Kind>
__device__ inline void write_simplices(const Block& block, int triangles) {
  const DualEdgeOutput& out = block.out;
  const DualEdgeMemory& m = block.m;
  const BlockBalls& s = block.s;
  if (threadIdx.x < 32) {
    if constexpr (Kind::kWhole)
      sum_before(triangles, m.triangles_before, [&](int w) { return __popc(m.found_bits[w]); });
    sum_before(triangles, m.tetrahedra_before,
               [&](int w) { return __popc(m.one_bits[w]) + __popc(m.two_bits[w]); });
    __syncwarp();
    reserve_output<Kind>(block);
  }
  __syncthreads();
  if constexpr (Kind::kWhole) write_edges(out.edges, m, s);
  const int kept = min(s.kept, static_cast<int>(block.p.capacity.kept));
  for (int a = threadIdx.x; a < kept; a += kBlockThreads) {
    const int number = static_cast<int>(m.kept[a].x);
    const Triangle t(block, number);
    if (s.exact[t.ball]) continue;
    const TriangleFace face = unpack_face(m.kept[a].y);
    const std::uint32_t* index = m.index + t.entry0;
    const uint3 ijk = make_uint3(s.index[t.ball], index[t.j], index[t.k]);
    if constexpr (Kind::kWhole) {
      const int first_later = s.list[t.ball] - s.later[t.ball];
      write_triangle(out.triangles, s.triangle_at[t.ball] + triangles_before(m, number), ijk,
                     pack_info(t.j - first_later, t.k - first_later, face.cofaces()),
                     attached_ball(face, index));
    }
    std::uint32_t to = s.tetrahedron_at[t.ball] + tetrahedra_before(m, number);
    const bool high_first = face.high < face.low;
    for (int e = 0; e < 2; ++e) {
      const int l = high_first == (e == 0) ? face.high : face.low;
      if (l <= t.k) continue;
      if (to < out.tetrahedra.capacity) {
        out.tetrahedra.vertices[to] = make_uint4(ijk.x, ijk.y, ijk.z, index[l]);
      }
      ++to;
    }
  }
}

}  // namespace alphascope::gpu
