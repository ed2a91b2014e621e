// SPDX-License-Identifier: GPL-3.0-or-later
// Launches the kernels that order the simplices of a chunk of balls (gather_kernels.cuh).
#pragma once

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include "gpu/dual_edge/gather_kernels.cuh"
#include "gpu/dual_edge/pipeline_state.cuh"

namespace alphascope::gpu {

// A chunk of balls with its own output lists.
struct Part {
  Chunk chunk;
  DualEdgeOutput out;
};

class Ordering {
 public:
  Ordering(DualEdgePipeline::State& state, const Problem& plan, const ResultLayout& layout,
           cudaStream_t stream)
      : s_(state), plan_(plan), stream_(stream), ordered_(ordered(layout)) {}

  // Orders tetrahedra, and triangles of a whole complex.
  void order_faces(const Part& part) {
    plan_.whole ? place_all_faces(part) : place_tetrahedra_alone(part);
    check(cudaGetLastError(), "ordering the simplices");
  }
  // Orders the edges and vertices of a whole complex. Must come after order_faces(), whose values
  // they need.
  void order_edges_and_vertices(const Part& part) {
    const Chunk& chunk = part.chunk;
    const DualEdgeOutput& out = part.out;
    const VertexStates vertices{out.vertex_state, s_.zeroed_array(plan_, 3),
                                s_.zeroed_array(plan_, 5)};
    if (chunk.begin > 0)
      launch(add_pending_cofaces, {4u * s_.multiprocessors, kThreads, stream_}, chunk, out,
             pending(), ordered_.dimension[2]);
    launch(finish_edges, lanes(chunk, kValueThreads, kValueBlocks), chunk, out, s_.balls.get(),
           vertices, s_.edges_found.get());
    sum(chunk, EdgeAndVertexCounts{out, vertices, s_.edges_found.get(), chunk.end});
    launch(place_edges_and_vertices, lanes(chunk, kThreads, 8), chunk, out, vertices,
           s_.places.get(), ordered_);
    check(cudaGetLastError(), "ordering the simplices");
  }

 private:
  OrderedResult ordered(const ResultLayout& layout) const {
    OrderedResult ordered{};
    ordered.ball = s_.balls.get();
    for (int d = 0; d < 4; ++d) {
      const ResultLayout::Section& at = layout.dimension[d];
      unsigned char* memory = s_.result.get();
      ordered.dimension[d] = {reinterpret_cast<std::uint32_t*>(memory + at.vertices),
                              reinterpret_cast<float*>(memory + at.value),
                              memory + at.simplex_class, &s_.counters()->hash[d],
                              static_cast<std::uint32_t>(layout.room[d])};
    }
    return ordered;
  }

  // The number of balls in a group, for kernels that take groups. Small chunks get small groups, so
  // that they keep the device busy.
  int group(const Chunk& chunk) const {
    const std::size_t share =
        (chunk.end - chunk.begin) / (8 * static_cast<std::size_t>(s_.multiprocessors));
    return static_cast<int>(std::clamp<std::size_t>(share, 16, kGroupBalls));
  }
  GroupedChunk grouped(const Chunk& chunk) const { return {chunk, group(chunk)}; }
  LaunchShape groups(const Chunk& chunk, unsigned most) const {
    const unsigned balls = chunk.end - chunk.begin, each = static_cast<unsigned>(group(chunk));
    return {std::clamp((balls + each - 1) / each, 1u, most * s_.multiprocessors), kValueThreads,
            stream_};
  }
  // The launch for kernels with kEdgeLanes threads per ball. It has no more blocks than run at
  // once.
  LaunchShape lanes(const Chunk& chunk, unsigned threads, unsigned most) const {
    const std::size_t all = std::size_t{chunk.end - chunk.begin} * kEdgeLanes;
    const auto blocks = static_cast<unsigned>((all + threads - 1) / threads);
    return {std::clamp(blocks, 1u, most * s_.multiprocessors), threads, stream_};
  }

  void place_tetrahedra_alone(const Part& part) {
    const Chunk& chunk = part.chunk;
    s_.scan(part.out.tetrahedra.count + chunk.begin, s_.offset.get() + chunk.begin,
            chunk.end - chunk.begin + 1, stream_);
    launch(place_tetrahedra, groups(chunk, 8), grouped(chunk), part.out.tetrahedra, s_.offset.get(),
           ordered_.dimension[3]);
  }

  void place_all_faces(const Part& part) {
    const Chunk& chunk = part.chunk;
    const DualEdgeOutput& out = part.out;
    sum(chunk, FaceCounts{out.tetrahedra.count, out.triangles.count, chunk.end});
    launch(place_faces, groups(chunk, 2 * kValueBlocks), grouped(chunk), out, s_.places.get(),
           pending(), ordered_);
  }
  PendingTriangles pending() const { return {s_.pending.get(), &s_.counters()->pending}; }

  // Sets for each of the chunk's balls, and after them, the sum of the pairs of the balls before.
  template <class Pairs>
  void sum(const Chunk& chunk, const Pairs& pairs) {
    s_.scan(thrust::make_transform_iterator(thrust::make_counting_iterator(chunk.begin), pairs),
            s_.places.get() + chunk.begin, chunk.end - chunk.begin + 1, stream_);
  }

  DualEdgePipeline::State& s_;
  const Problem& plan_;
  const cudaStream_t stream_;
  const OrderedResult ordered_;
};

}  // namespace alphascope::gpu
