// SPDX-License-Identifier: GPL-3.0-or-later
// Copies a result to the host, whole or in parts, and lays out its arrays there.
#pragma once

#include <cstring>

#include "gpu/dual_edge/pipeline_state.cuh"

namespace alphascope::gpu {

class ResultCopy {
 public:
  ResultCopy(DualEdgePipeline::State& state, bool whole) : s_(state), whole_(whole) {}

  // Reserves memory on the host. Returns whether the system was asked for more.
  bool make_room(const ResultLayout& layout) {
    if (layout.host_bytes <= room_) return false;
    memory_.reset();
    room_ = 0;
    auto [memory, grew] = s_.results->take(layout.host_bytes);
    memory_ = std::move(memory);
    room_ = layout.host_bytes;
    return grew;
  }
  // Writes the classes of tetrahedra, which need no copy. Other arrays may be on their way
  // meanwhile.
  void write_interior_classes(const ResultLayout& layout) {
    const std::size_t tetrahedra = layout.host_bytes - layout.bytes;
    if (tetrahedra == 0) return;
    std::memset(memory_.get() + layout.dimension[3].simplex_class,
                static_cast<int>(SimplexClass::interior), tetrahedra);
  }

  // Copy whole sections of the result's memory, for a run in a single chunk.
  void all_faces(const ResultLayout& layout, cudaStream_t stream) {
    const std::size_t begin = layout.dimension[2].vertices;
    copy_to_host(begin, begin, layout.bytes - begin, stream);
  }
  void all_edges_and_vertices(const ResultLayout& layout, cudaStream_t stream) {
    copy_to_host(0, 0, layout.dimension[2].vertices, stream);
  }
  // Copies only the simplices found, to a layout that fits exactly and has been reserved.
  void found(const ResultLayout& from, const ResultLayout& to, cudaStream_t stream) {
    part(from, to, {{{0, 0, 0, 0}}, totals_of(to.room), 0, 4}, stream);
  }
  // Returns whether there is room for the simplices that a chunk adds.
  static bool has_place(const ResultLayout& layout, const Totals& before, const Totals& after) {
    for (int d = 0; d < 4; ++d) {
      const std::size_t room = layout.room[d];
      if (after.of[d] < before.of[d] || after.of[d] > room) return false;
    }
    return true;
  }
  void added_faces(const ResultLayout& layout, const Totals& before, const Totals& after,
                   cudaStream_t stream) {
    part(layout, layout, {before, after, 2, 4}, stream);
  }
  void added_edges_and_vertices(const ResultLayout& layout, const Totals& before,
                                const Totals& after, cudaStream_t stream) {
    part(layout, layout, {before, after, 0, 2}, stream);
  }

  PipelineResult result(const ResultLayout& layout, const SimplexCounts& counts) const {
    PipelineResult result;
    result.memory = memory_;
    const Counters& got = *s_.host_counters.get();
    for (const std::uint32_t balls : got.exact_count) result.exact_balls += balls;
    for (int d = 0; d < 4; ++d) {
      result.hash.sum[d] = got.hash[d];
      result.hash.count[d] = whole_ || d == 3 ? counts[d] : 0;
    }
    if (whole_) {
      result.vertices = simplices<1>(layout, counts);
      result.edges = simplices<2>(layout, counts);
      result.triangles = simplices<3>(layout, counts);
    }
    result.tetrahedra = simplices<4>(layout, counts);
    return result;
  }

 private:
  // Simplices [before, after) of each of the dimensions [begin, end).
  struct Part {
    Totals before, after;
    int begin, end;
  };
  static Totals totals_of(const SimplexCounts& counts) {
    Totals totals{};
    for (int d = 0; d < 4; ++d) totals.of[d] = static_cast<std::uint32_t>(counts[d]);
    return totals;
  }

  void copy_to_host(std::size_t begin, std::size_t place, std::size_t bytes, cudaStream_t stream) {
    if (bytes == 0) return;
    check(cudaMemcpyAsync(memory_.get() + place, s_.result.get() + begin, bytes,
                          cudaMemcpyDeviceToHost, stream),
          "copying the result");
  }
  void part(const ResultLayout& from, const ResultLayout& to, const Part& which,
            cudaStream_t stream) {
    for (int d = whole_ ? which.begin : 3; d < which.end; ++d) {
      const ResultLayout::Section &source = from.dimension[d], &target = to.dimension[d];
      const std::size_t begin = which.before.of[d], count = which.after.of[d] - begin;
      const auto array = [&](std::size_t at, std::size_t place, std::size_t size) {
        copy_to_host(at + begin * size, place + begin * size, count * size, stream);
      };
      array(source.vertices, target.vertices, 4 * static_cast<std::size_t>(d + 1));
      if (!whole_) continue;
      array(source.value, target.value, 4);
      if (d < 3) array(source.simplex_class, target.simplex_class, 1);
    }
  }

  template <int N>
  HostSimplices<N> simplices(const ResultLayout& layout, const SimplexCounts& counts) const {
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(std::uint32_t));
    const ResultLayout::Section& at = layout.dimension[N - 1];
    unsigned char* memory = memory_.get();
    HostSimplices<N> list;
    list.simplices = {reinterpret_cast<std::array<BallIndex, N>*>(memory + at.vertices),
                      counts[N - 1]};
    if (!whole_) return list;
    list.values = {reinterpret_cast<float*>(memory + at.value), counts[N - 1]};
    list.classes = {reinterpret_cast<SimplexClass*>(memory + at.simplex_class), counts[N - 1]};
    return list;
  }

  DualEdgePipeline::State& s_;
  const bool whole_;
  std::shared_ptr<unsigned char> memory_;
  std::size_t room_ = 0;  // size of that memory, bytes
};

}  // namespace alphascope::gpu
