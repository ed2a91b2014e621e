// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the output of blocks into the result in lexicographic order. Tetrahedra and triangles move
// to their places. Edges get values and classes from triangles, and vertices from edges. The CPU's
// version is core/dual_edge/gather_faces.hpp.
#pragma once

#include "core/complex/face_class.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/geometry/ordered_bits.hpp"
#include "gpu/dual_edge/dual_edge_block.cuh"
#include "gpu/dual_edge/simplex_values.cuh"

namespace alphascope::gpu {

// One dimension of a result, in order.
struct OrderedSimplices {
  std::uint32_t* vertices;
  float* value;
  std::uint8_t* simplex_class;
  std::uint64_t* hash;  // HashSums::sum, to which each simplex is added
  std::uint32_t capacity;
};
struct OrderedResult {
  OrderedSimplices dimension[4];
  const int4* ball;  // by index
};

// A chunk in which each block of threads takes groups of this many balls.
struct GroupedChunk : Chunk {
  int group;
};

// Two numbers of a ball in one word, so that one prefix sum adds up both. After the last ball comes
// a pair of zeros, so that the last sum is the total.
__device__ inline std::uint64_t pair_of(std::uint32_t low, std::uint32_t high) {
  return static_cast<std::uint64_t>(high) << 32 | low;
}
__host__ __device__ inline std::uint32_t low_of(std::uint64_t pair) {
  return static_cast<std::uint32_t>(pair);
}
__host__ __device__ inline std::uint32_t high_of(std::uint64_t pair) {
  return static_cast<std::uint32_t>(pair >> 32);
}

// The numbers of tetrahedra and triangles of a ball; 0 after the chunk's last ball.
struct FaceCounts {
  const std::uint32_t *tetrahedra, *triangles;
  std::uint32_t chunk_end;

  __device__ std::uint64_t operator()(std::uint32_t i) const {
    return i == chunk_end ? 0 : pair_of(tetrahedra[i], triangles[i]);
  }
};

// The simplices of one dimension of a group of balls, numbered consecutively.
constexpr int kGroupBalls = 256;
struct GroupItems {
  // For each ball the start of its simplices in the blocks' output.
  std::uint32_t start[kGroupBalls];
  // For each ball the number of simplices of the balls before it in the group
  std::uint32_t before[kGroupBalls + 1];
  std::uint32_t place;  // place of the group's first simplex in the result

  // Every thread must call it. `places(i)`: number of simplices of the chunk's balls before i.
  // `starts` is unset for a ball without simplices, and is then not read.
  template <class Places>
  __device__ void load(std::uint32_t first, int balls, const std::uint32_t* starts,
                       const Places& places, std::uint32_t before_chunk) {
    const std::uint32_t at = places(first);
    for (int b = threadIdx.x; b <= balls; b += blockDim.x) {
      const std::uint32_t own = places(first + b);
      before[b] = own - at;
      if (b < balls) start[b] = places(first + b + 1) > own ? starts[first + b] : 0;
    }
    if (threadIdx.x == 0) place = before_chunk + at;
  }
  __device__ std::uint32_t count(int balls) const { return before[balls]; }
  // The place of the t-th simplex in the blocks' output.
  __device__ std::uint32_t source(std::uint32_t t, int balls) const {
    int low = 0, high = balls;
    while (low + 1 < high) {
      const int middle = (low + high) / 2;
      (before[middle] <= t ? low : high) = middle;
    }
    return start[low] + (t - before[low]);
  }
};

constexpr std::uint32_t kNoEdge = ~0u;

// The place of edge jk of a triangle in K_alpha among the candidates of j, which are ascending.
// Returns kNoEdge and counts the edge as missing if it is not there. An edge is missing only if
// ball j found no room; the run is then repeated.
__device__ inline std::uint32_t find_edge(const EdgeCandidates& edges, std::uint32_t j,
                                          std::uint32_t k) {
  const std::uint32_t count = edges.count[j];
  if (count != 0) {
    std::uint32_t low = edges.start[j], high = low + count;
    while (low + 1 < high) {
      const std::uint32_t middle = (low + high) / 2;
      (edges.end[middle] <= k ? low : high) = middle;
    }
    if (edges.end[low] == k) return low;
  }
  atomicAdd(edges.missing, 1u);
  return kNoEdge;
}

// An edge of a triangle. Its flags are read as soon as it is found, not only when they change. So
// the reads of several edges overlap.
struct EdgeOfTriangle {
  std::uint32_t edge, known;

  __device__ EdgeOfTriangle(const EdgeCandidates& edges, std::uint32_t e)
      : edge(e), known(e != kNoEdge ? edges.flags[e] : 0) {}
  // Adds the value and class of the triangle.
  __device__ void add_coface(const EdgeCandidates& edges, std::uint32_t value,
                             std::uint32_t flags) const {
    if (edge == kNoEdge) return;
    if (!(known & kUnattached)) atomicMin(&edges.least[edge], value);
    if ((known & flags) != flags) atomicOr(&edges.flags[edge], flags);
  }
};

// Adds the values of all threads of a block to `sum`. Every thread must call it.
__device__ inline void add_block_sum(std::uint64_t own, std::uint64_t* sum) {
  __shared__ std::uint64_t all;
  if (threadIdx.x == 0) all = 0;
  __syncthreads();
  for (int step = 16; step > 0; step /= 2) own += __shfl_xor_sync(~0u, own, step);
  if ((threadIdx.x & 31) == 0) add(&all, own);
  __syncthreads();
  if (threadIdx.x == 0 && all != 0) add(sum, all);
  __syncthreads();
}

// Triangles whose edge jk belongs to a ball of a later chunk: their places in the result. That
// chunk adds their values to the edge.
struct PendingTriangles {
  std::uint32_t* places;
  std::uint32_t* count;
};

// A move of a simplex from the blocks' output to its place in the result.
struct Move {
  std::uint32_t from, to;
};

// Places a triangle, computes its value and adds it to its edges. Returns its hash.
__device__ inline std::uint64_t place_triangle(const DualEdgeOutput& from, const Move& move,
                                               const Chunk& chunk, const PendingTriangles& pending,
                                               const OrderedResult& to) {
  const std::uint32_t t = move.from, at = move.to;
  const OrderedSimplices& out = to.dimension[2];
  const std::uint32_t* v = from.triangles.vertices + 3 * static_cast<std::size_t>(t);
  const std::uint32_t i = v[0], j = v[1], k = v[2], info = from.triangles.info[t];
  const std::uint32_t l = from.triangles.attached_to[t];
  if (at >= out.capacity) return 0;
  // The kernel mostly waits for memory. So it starts all reads that it can before it uses any
  // result.
  const bool attached = l != kNoBall, pends = j >= chunk.end;
  const SimplexBalls balls = simplex_balls<4>(to.ball, make_uint4(i, j, k, attached ? l : j));
  const std::uint32_t own = from.edges.start[i];
  const EdgeOfTriangle ij(from.edges, own + (info & 4095)),
      ik(from.edges, own + (info >> 12 & 4095)),
      jk(from.edges, pends ? kNoEdge : find_edge(from.edges, j, k));
  const float value = attached ? ortho_radius<4>(balls) : ortho_radius<3>(balls);
  const SimplexClass own_class = triangle_class(static_cast<int>(info >> 24));
  const std::uint32_t bits = ordered_bits(value), flags = coface_flags(own_class);
  ij.add_coface(from.edges, bits, flags);
  ik.add_coface(from.edges, bits, flags);
  jk.add_coface(from.edges, bits, flags);
  if (pends) pending.places[atomicAdd(pending.count, 1u)] = at;
  std::uint32_t* place = out.vertices + 3 * static_cast<std::size_t>(at);
  place[0] = i;
  place[1] = j;
  place[2] = k;
  out.value[at] = value;
  out.simplex_class[at] = static_cast<std::uint8_t>(own_class);
  const std::uint32_t vertices[3] = {i, j, k};
  return simplex_hash<3>(vertices);
}

__device__ inline std::uint64_t hash_of(const uint4& tetrahedron) {
  const std::uint32_t v[4] = {tetrahedron.x, tetrahedron.y, tetrahedron.z, tetrahedron.w};
  return simplex_hash<4>(v);
}

// Returns whether there is no room for all simplices found. The run is then repeated with more.
__device__ inline bool seems_overfull(const DualEdgeOutput& from) {
  return *from.triangles.cursor > from.triangles.capacity ||
         *from.tetrahedra.cursor > from.tetrahedra.capacity ||
         *from.edges.cursor > from.edges.capacity;
}
// The same for a block. Kernel II of later chunks may be running, so threads could see different
// numbers. Every thread must call it, and all get the same answer.
__device__ inline bool is_overfull(const DualEdgeOutput& from) {
  return __syncthreads_or(seems_overfull(from)) != 0;
}

// Calls visit(first ball, number of balls) for groups of the chunk's balls, block after block.
template <class Visit>
__device__ inline void for_groups(const GroupedChunk& chunk, const Visit& visit) {
  const int group = chunk.group;
  for (std::uint32_t first = chunk.begin + blockIdx.x * group; first < chunk.end;
       first += gridDim.x * group) {
    visit(first, static_cast<int>(min(static_cast<std::uint32_t>(group), chunk.end - first)));
    __syncthreads();
  }
}

// Places the chunk's triangles and tetrahedra. `places`: sums of FaceCounts.
__global__ void __launch_bounds__(kValueThreads, kValueBlocks)
    place_faces(GroupedChunk chunk, DualEdgeOutput from, const std::uint64_t* places,
                PendingTriangles pending, OrderedResult to) {
  __shared__ GroupItems triangles, tetrahedra;
  if (is_overfull(from)) return;
  const Totals before = *chunk.before;
  std::uint64_t triangle_hash = 0, tetrahedron_hash = 0;
  for_groups(chunk, [&](std::uint32_t first, int balls) {
    triangles.load(
        first, balls, from.triangles.start, [&](std::uint32_t i) { return high_of(places[i]); },
        before.of[2]);
    tetrahedra.load(
        first, balls, from.tetrahedra.start, [&](std::uint32_t i) { return low_of(places[i]); },
        before.of[3]);
    __syncthreads();
    for (std::uint32_t t = threadIdx.x; t < triangles.count(balls); t += blockDim.x)
      triangle_hash += place_triangle(from, {triangles.source(t, balls), triangles.place + t},
                                      chunk, pending, to);
    for (std::uint32_t t = threadIdx.x; t < tetrahedra.count(balls); t += blockDim.x) {
      const uint4 v = from.tetrahedra.vertices[tetrahedra.source(t, balls)];
      const std::uint32_t at = tetrahedra.place + t;
      const OrderedSimplices& out = to.dimension[3];
      if (at >= out.capacity) continue;
      reinterpret_cast<uint4*>(out.vertices)[at] = v;
      out.value[at] = ortho_radius<4>(simplex_balls<4>(to.ball, v));
      tetrahedron_hash += hash_of(v);
    }
  });
  add_block_sum(triangle_hash, to.dimension[2].hash);
  add_block_sum(tetrahedron_hash, to.dimension[3].hash);
  if (blockIdx.x != 0 || threadIdx.x != 0) return;
  chunk.before[1].of[2] = before.of[2] + high_of(places[chunk.end]);
  chunk.before[1].of[3] = before.of[3] + low_of(places[chunk.end]);
}

// Places the chunk's tetrahedra alone, without values.
__global__ void place_tetrahedra(GroupedChunk chunk, FoundTetrahedra from,
                                 const std::uint32_t* places, OrderedSimplices to) {
  __shared__ GroupItems tetrahedra;
  if (__syncthreads_or(*from.cursor > from.capacity)) return;  // as is_overfull()
  const std::uint32_t before = chunk.before->of[3];
  std::uint64_t sum = 0;
  for_groups(chunk, [&](std::uint32_t first, int balls) {
    tetrahedra.load(
        first, balls, from.start, [&](std::uint32_t i) { return places[i]; }, before);
    __syncthreads();
    for (std::uint32_t t = threadIdx.x; t < tetrahedra.count(balls); t += blockDim.x) {
      const uint4 v = from.vertices[tetrahedra.source(t, balls)];
      const std::uint32_t at = tetrahedra.place + t;
      if (at >= to.capacity) continue;
      reinterpret_cast<uint4*>(to.vertices)[at] = v;
      sum += hash_of(v);
    }
  });
  add_block_sum(sum, to.hash);
  if (blockIdx.x == 0 && threadIdx.x == 0) chunk.before[1].of[3] = before + places[chunk.end];
}

// Adds the triangles of earlier chunks to edges of this one.
__global__ void add_pending_cofaces(Chunk chunk, DualEdgeOutput from, PendingTriangles pending,
                                    OrderedSimplices triangles) {
  if (is_overfull(from)) return;
  const std::uint32_t count = *pending.count, step = gridDim.x * blockDim.x;
  for (std::uint32_t a = blockIdx.x * blockDim.x + threadIdx.x; a < count; a += step) {
    const std::uint32_t at = pending.places[a];
    const std::uint32_t* v = triangles.vertices + 3 * static_cast<std::size_t>(at);
    if (v[1] < chunk.begin || v[1] >= chunk.end) continue;
    EdgeOfTriangle(from.edges, find_edge(from.edges, v[1], v[2]))
        .add_coface(from.edges, ordered_bits(triangles.value[at]),
                    coface_flags(static_cast<SimplexClass>(triangles.simplex_class[at])));
  }
}

// Data of vertices that edges contribute.
struct VertexStates {
  std::uint32_t* state;     // as DualEdgeOutput::vertex_state
  std::uint32_t* flags;     // coface flags of the edges in K_alpha
  std::uint32_t* greatest;  // ~ordered_bits of their least value, so that 0 means none
};

// The flags of a vertex, as those of an edge.
__device__ inline std::uint32_t vertex_flags(const VertexStates& v, std::uint32_t i) {
  return v.flags[i] | (v.state[i] == 2 ? kUnattached : 0);
}

// Number of lanes that process one ball's edges.
constexpr int kEdgeLanes = 8;

// Calls visit(candidate, number of those before it in K_alpha) for the edges of one ball in
// K_alpha. Takes kEdgeLanes at a time. Every lane of the warp must call it. Returns their number.
// `edges.start` is unset for a ball that found no room, whose count is 0; it is then not read. Such
// a run is repeated.
template <class Visit>
__device__ inline std::uint32_t for_edges(const EdgeCandidates& edges, std::uint32_t ball,
                                          bool active, const Visit& visit) {
  const int lane = threadIdx.x & (kEdgeLanes - 1), group = threadIdx.x & 31 & ~(kEdgeLanes - 1);
  const std::uint32_t count = active ? edges.count[ball] : 0,
                      begin = count != 0 ? edges.start[ball] : 0, end = begin + count;
  std::uint32_t found = 0;
  for (std::uint32_t e = begin + lane; __any_sync(~0u, e < end); e += kEdgeLanes) {
    const bool there = e < end && is_in_complex(edges.flags[e]);
    const unsigned all = __ballot_sync(~0u, there) >> group & ((1u << kEdgeLanes) - 1);
    if (there) visit(e, found + __popc(all & ((1u << lane) - 1)));
    found += __popc(all);
  }
  return found;
}

// Calls visit(ball, whether it exists) for the chunk's balls, with kEdgeLanes lanes for each.
template <class Visit>
__device__ inline void for_balls(const Chunk& chunk, const Visit& visit) {
  const std::uint32_t step = gridDim.x * blockDim.x / kEdgeLanes;
  for (std::uint32_t i = chunk.begin + (blockIdx.x * blockDim.x + threadIdx.x) / kEdgeLanes;
       __any_sync(~0u, i < chunk.end); i += step)
    visit(i, i < chunk.end);
}

// The contribution of edges in K_alpha to a vertex, as in VertexStates.
struct CofaceSummary {
  std::uint32_t flags = 0, greatest = 0;

  __device__ void add(const CofaceSummary& more) {
    flags |= more.flags;
    greatest = max(greatest, more.greatest);
  }
  // Adds the contributions of all lanes of a ball. Every lane of the warp must call it.
  __device__ void add_lanes() {
    for (int step = 1; step < kEdgeLanes; step *= 2)
      add({__shfl_xor_sync(~0u, flags, step), __shfl_xor_sync(~0u, greatest, step)});
  }
};

// A vertex. Its data is read as soon as it is met, as in EdgeOfTriangle.
struct VertexOfEdges {
  std::uint32_t vertex, known, state, greatest;

  __device__ VertexOfEdges(const VertexStates& vertices, const Chunk& chunk, std::uint32_t v)
      : vertex(v),
        known(vertices.flags[v]),
        // In a later chunk the state is not known yet.
        state(v >= chunk.end ? 1 : vertices.state[v]),
        greatest(vertices.greatest[v]) {}
  __device__ void add_cofaces(const VertexStates& vertices, const CofaceSummary& news) const {
    if ((known & news.flags) != news.flags) atomicOr(&vertices.flags[vertex], news.flags);
    if (state == 1 && greatest < news.greatest)
      atomicMax(&vertices.greatest[vertex], news.greatest);
  }
};

// An edge by its lower ball and its place among the candidates.
struct OwnEdge {
  std::uint32_t begin, candidate;
};
// Computes the value of an unattached edge of K_alpha and adds the edge to its higher ball. Returns
// the contribution to its lower ball.
__device__ inline CofaceSummary finish_edge(const int4* ball, const EdgeCandidates& edges,
                                            const VertexStates& vertices, const Chunk& chunk,
                                            const OwnEdge& edge) {
  const std::uint32_t begin = edge.begin, e = edge.candidate;
  const std::uint32_t flags = edges.flags[e], end = edges.end[e];
  std::uint32_t least = edges.least[e];
  const VertexOfEdges told(vertices, chunk, end);
  if (flags & kUnattached) {
    least = ordered_bits(ortho_radius<2>(simplex_balls<2>(ball, make_uint4(begin, end, 0, 0))));
    edges.least[e] = least;
  }
  const CofaceSummary news{coface_flags(face_class(flags)), ~least};
  told.add_cofaces(vertices, news);
  return news;
}

// Completes the edges of the chunk's balls. `found`: number of edges in K_alpha for each ball.
__global__ void __launch_bounds__(kValueThreads, kValueBlocks)
    finish_edges(Chunk chunk, DualEdgeOutput from, const int4* ball, VertexStates vertices,
                 std::uint32_t* found) {
  if (is_overfull(from)) return;
  for_balls(chunk, [&](std::uint32_t i, bool active) {
    CofaceSummary news;
    const std::uint32_t count =
        for_edges(from.edges, i, active, [&](std::uint32_t e, std::uint32_t) {
          news.add(finish_edge(ball, from.edges, vertices, chunk, {i, e}));
        });
    news.add_lanes();
    if (!active || threadIdx.x % kEdgeLanes != 0) return;
    if (count != 0) VertexOfEdges(vertices, chunk, i).add_cofaces(vertices, news);
    found[i] = count;
  });
}

// The number of a ball's edges, and whether it is a vertex; 0 after the chunk's last ball. If there
// is no room, nothing was counted.
struct EdgeAndVertexCounts {
  DualEdgeOutput from;
  VertexStates vertices;
  const std::uint32_t* found;  // written by finish_edges()
  std::uint32_t chunk_end;

  __device__ std::uint64_t operator()(std::uint32_t i) const {
    return i == chunk_end || seems_overfull(from)
               ? 0
               : pair_of(found[i], is_in_complex(vertex_flags(vertices, i)));
  }
};

// Writes vertex i and returns its hash.
__device__ inline std::uint64_t place_vertex(std::uint32_t i, const VertexStates& vertices,
                                             std::uint32_t at, const OrderedResult& to) {
  const OrderedSimplices& out = to.dimension[0];
  if (at >= out.capacity) return 0;
  const int4* ball = to.ball;
  const double weight = static_cast<double>(static_cast<std::int64_t>(ball[i].w) * ball[i].w);
  const std::uint32_t flags = vertex_flags(vertices, i);
  out.vertices[at] = i;
  out.value[at] = face_value(flags, from_ordered_bits(~vertices.greatest[i]),
                             [&] { return static_cast<float>(-weight); });
  out.simplex_class[at] = static_cast<std::uint8_t>(face_class(flags));
  return simplex_hash<1>(&i);
}

// Writes the chunk's edges and vertices. `places`: sums of EdgeAndVertexCounts.
__global__ void place_edges_and_vertices(Chunk chunk, DualEdgeOutput from, VertexStates vertices,
                                         const std::uint64_t* places, OrderedResult to) {
  if (is_overfull(from)) return;
  const Totals before = *chunk.before;
  const EdgeCandidates& edges = from.edges;
  std::uint64_t edge_hash = 0, vertex_hash = 0;
  for_balls(chunk, [&](std::uint32_t i, bool active) {
    const std::uint32_t first = active ? before.of[1] + low_of(places[i]) : 0;
    for_edges(edges, i, active, [&](std::uint32_t e, std::uint32_t number) {
      const std::uint32_t at = first + number, v[2] = {i, edges.end[e]};
      const OrderedSimplices& out = to.dimension[1];
      if (at >= out.capacity) return;
      reinterpret_cast<uint2*>(out.vertices)[at] = make_uint2(v[0], v[1]);
      out.value[at] = from_ordered_bits(edges.least[e]);
      out.simplex_class[at] = static_cast<std::uint8_t>(face_class(edges.flags[e]));
      edge_hash += simplex_hash<2>(v);
    });
    if (active && threadIdx.x % kEdgeLanes == 0 && is_in_complex(vertex_flags(vertices, i)))
      vertex_hash += place_vertex(i, vertices, before.of[0] + high_of(places[i]), to);
    __syncwarp();
  });
  add_block_sum(vertex_hash, to.dimension[0].hash);
  add_block_sum(edge_hash, to.dimension[1].hash);
  if (blockIdx.x != 0 || threadIdx.x != 0) return;
  chunk.before[1].of[0] = before.of[0] + high_of(places[chunk.end]);
  chunk.before[1].of[1] = before.of[1] + low_of(places[chunk.end]);
}

}  // namespace alphascope::gpu
