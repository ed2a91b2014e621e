// Starts what brings the simplices of a chunk of balls into their order (gather_kernels.cuh).
#pragma once

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include "gpu/gather_kernels.cuh"
#include "gpu/pipeline_state.cuh"

namespace alphascope::gpu {

// What runs for one chunk: its balls, and lists of its own.
struct Part {
  Chunk chunk;
  DualEdgeOutput out;
};

class Ordering {
 public:
  Ordering(FacetPipeline::State& state, const Problem& plan, const ResultLayout& layout,
           cudaStream_t stream)
      : s_(state), plan_(plan), stream_(stream), ordered_(ordered(layout)) {}

  void enqueue(const Part& part) {
    plan_.whole ? order_all(part) : order_tetrahedra(part);
    check(cudaGetLastError(), "ordering the simplices");
  }

 private:
  OrderedResult ordered(const ResultLayout& layout) const {
    OrderedResult ordered{};
    for (int d = 0; d < 4; ++d) {
      const ResultLayout::Section& at = layout.dimension[d];
      unsigned char* memory = s_.result.get();
      ordered.dimension[d] = {reinterpret_cast<std::uint32_t*>(memory + at.vertices),
                              reinterpret_cast<float*>(memory + at.value),
                              memory + at.simplex_class,
                              static_cast<std::uint32_t>(layout.room[d])};
    }
    return ordered;
  }

  // For kernels that take groups of balls: how many balls, so that small sets keep the device busy.
  int group() const {
    const std::size_t share = s_.n / (8 * static_cast<std::size_t>(s_.multiprocessors));
    return static_cast<int>(std::clamp<std::size_t>(share, 16, kGroupBalls));
  }
  LaunchShape groups(const Chunk& chunk, unsigned most) const {
    const unsigned balls = chunk.end - chunk.begin, each = static_cast<unsigned>(group());
    return {std::clamp((balls + each - 1) / each, 1u, most * s_.multiprocessors), kValueThreads,
            stream_};
  }

  void order_tetrahedra(const Part& part) {
    const Chunk& chunk = part.chunk;
    s_.scan(part.out.tetrahedra.count + chunk.begin, s_.offset.get() + chunk.begin,
            chunk.end - chunk.begin + 1, stream_);
    launch(place_tetrahedra, groups(chunk, 8), chunk, group(), part.out.tetrahedra, s_.offset.get(),
           ordered_.dimension[3], &s_.counters()->hash[3]);
  }

  void order_all(const Part& part) {
    const Chunk& chunk = part.chunk;
    const DualEdgeOutput& out = part.out;
    const VertexStates vertices{out.vertex_state, s_.zeroed_array(plan_, 3),
                                s_.zeroed_array(plan_, 5)};
    const PendingTriangles pending{s_.pending.get(), &s_.counters()->pending};
    const unsigned most = 2u * kValueBlocks;
    // Not more blocks than needed at once: each adds to the one hash.
    const LaunchShape per_edge{
        std::clamp(blocks_for(std::size_t{chunk.end - chunk.begin} * kEdgeLanes), 1u,
                   8u * s_.multiprocessors),
        kThreads, stream_};
    LaunchShape values = per_edge;
    values.threads = kValueThreads;
    sum(chunk, FaceCounts{out.tetrahedra.count, out.triangles.count, chunk.end});
    launch(place_faces, groups(chunk, most), chunk, group(), out, s_.balls.get(), s_.places.get(),
           pending, ordered_, &s_.counters()->hash[0]);
    if (chunk.begin > 0)
      launch(tell_pending, {4u * s_.multiprocessors, kThreads, stream_}, chunk, out, pending,
             ordered_.dimension[2]);
    launch(finish_edges, values, chunk, out, s_.balls.get(), vertices, s_.edges_found.get());
    sum(chunk, EdgeAndVertexCounts{out, vertices, s_.edges_found.get(), chunk.end});
    launch(place_edges_and_vertices, per_edge, chunk, out, s_.balls.get(), vertices,
           s_.places.get(), ordered_, &s_.counters()->hash[0]);
  }

  // For each of the chunk's balls, and after them: the sum of the pairs of those before.
  template <class Pairs>
  void sum(const Chunk& chunk, const Pairs& pairs) {
    s_.scan(thrust::make_transform_iterator(thrust::make_counting_iterator(chunk.begin), pairs),
            s_.places.get() + chunk.begin, chunk.end - chunk.begin + 1, stream_);
  }

  FacetPipeline::State& s_;
  const Problem& plan_;
  const cudaStream_t stream_;
  const OrderedResult ordered_;
};

}  // namespace alphascope::gpu
