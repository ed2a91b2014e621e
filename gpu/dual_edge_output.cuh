// From the triangles that a block found to the simplices it writes: order and places.
#pragma once

#include <climits>

#include "gpu/dual_edge_block.cuh"
#include "gpu/ordered_bits.cuh"

namespace alphascope::gpu {

// Found triangles and tetrahedra before triangle t of the block.
__device__ inline std::uint32_t triangles_before(const DualEdgeMemory& m, int t) {
  const std::uint32_t below = (1u << (t & 31)) - 1;
  return m.triangles_before[t >> 5] + __popc(m.found_bits[t >> 5] & below);
}
__device__ inline std::uint32_t tetrahedra_before(const DualEdgeMemory& m, int t) {
  const std::uint32_t below = (1u << (t & 31)) - 1;
  return m.tetrahedra_before[t >> 5] + __popc(m.one_bits[t >> 5] & below) +
         __popc(m.two_bits[t >> 5] & below);
}

// Sums the bits of the words before each. Every thread takes part.
template <class Kind>
__device__ inline void sum_found(const DualEdgeMemory& m, BlockBalls& s, int triangles) {
  const int words = (triangles >> 5) + 1;
  int faces = 0, ends = 0;
  for (int w0 = 0; w0 < words; w0 += kBlockThreads) {
    const int w = w0 + static_cast<int>(threadIdx.x);
    int round = 0;
    if constexpr (Kind::kWhole) {
      const int before = block_scan(w < words ? __popc(m.found_bits[w]) : 0, s.scan, &round);
      if (w < words) m.triangles_before[w] = faces + before;
      faces += round;
    }
    const int before =
        block_scan(w < words ? __popc(m.one_bits[w]) + __popc(m.two_bits[w]) : 0, s.scan, &round);
    if (w < words) m.tetrahedra_before[w] = ends + before;
    ends += round;
  }
  __syncthreads();
}

// Room for so many simplices of each lane's ball, in the order of rows: where they begin. One warp.
__device__ inline std::uint32_t claim(int own, int row0, int balls, std::uint32_t* cursor) {
  std::uint32_t before = 0, all = 0;
  for (int o = 0; o < balls; ++o) {
    const int other = __shfl_sync(~0u, own, o);
    if (__shfl_sync(~0u, row0, o) < row0) before += other;
    all += other;
  }
  std::uint32_t base = 0;
  if (threadIdx.x == 0 && all != 0) base = atomicAdd(cursor, all);
  return __shfl_sync(~0u, base, 0) + before;
}

// Where the simplices of each ball go; balls for kernel III are listed instead. One warp.
template <class Kind>
__device__ inline void claim_places(const DualEdgeOutput& out, const DualEdgeMemory& m,
                                    BlockBalls& s, std::uint32_t first, int balls) {
  const int b = static_cast<int>(threadIdx.x);
  const bool mine = b < balls && !s.exact[b];
  const int row0 = b < balls ? s.row0[b] : 0;
  const bool any = mine && s.first_triangle[b] < s.end_triangle[b];
  const auto claimed = [&](auto before, const auto& to, std::uint32_t& at) {
    const std::uint32_t begin = any ? before(m, s.first_triangle[b]) : 0,
                        own = any ? before(m, s.end_triangle[b]) - begin : 0;
    const std::uint32_t start = claim(static_cast<int>(own), row0, balls, to.cursor);
    if (!mine) return;
    to.start[s.index[b]] = start;
    to.count[s.index[b]] = own;
    at = start - begin;
  };
  claimed([](const DualEdgeMemory& from, int t) { return tetrahedra_before(from, t); },
          out.tetrahedra, s.tetrahedron_at[b & (kMaxBallsPerBlock - 1)]);
  if constexpr (Kind::kWhole) {
    claimed([](const DualEdgeMemory& from, int t) { return triangles_before(from, t); },
            out.triangles, s.triangle_at[b & (kMaxBallsPerBlock - 1)]);
    const int edges = mine ? s.later[b] : 0;
    const std::uint32_t start = claim(edges, row0, balls, out.edges.cursor);
    if (mine) {
      out.edges.start[s.index[b]] = start;
      out.edges.count[s.index[b]] = edges;
      s.edge_at[b] = start - row0;
    }
  }
  if (!Kind::kExact && b < balls && s.exact[b]) {  // all of this ball is done again
    out.exact_list[atomicAdd(out.exact_count, 1u)] = first + b;
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
    out.begin[to] = s.index[b];
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

// The ball that ends the dual edge where the triangle is attached.
__device__ inline std::uint32_t attached_ball(const TriangleFace& f, const std::uint32_t* index) {
  using Attached = TriangleFace::Attached;
  return f.attached == Attached::no ? kNoBall
                                    : index[f.attached == Attached::high ? f.high : f.low];
}

// Writes the simplices of all balls but those for kernel III, and where each ball's are.
template <class Kind>
__device__ inline void write_simplices(const DualEdgeProblem& p, const DualEdgeOutput& out,
                                       const DualEdgeMemory& m, BlockBalls& s, std::uint32_t first,
                                       int balls, int triangles, int words) {
  sum_found<Kind>(m, s, triangles);
  if (threadIdx.x < 32) claim_places<Kind>(out, m, s, first, balls);
  __syncthreads();
  if constexpr (Kind::kWhole) write_edges(out.edges, m, s);
  const int kept = min(s.kept, static_cast<int>(p.capacity.kept));
  for (int a = threadIdx.x; a < kept; a += kBlockThreads) {
    const int number = static_cast<int>(m.kept[a].x);
    const Triangle t(m, s, words, m.triangles[number]);
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
