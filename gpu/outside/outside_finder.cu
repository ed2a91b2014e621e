// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the outer faces of tetrahedra on the device: memory, copies and the order of kernels.
#include "gpu/outside/outside_finder.hpp"

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include <limits>

#include "core/complex/shared_faces.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/memory/result_memory.cuh"
#include "gpu/memory/work_stream.cuh"
#include "gpu/outside/outside_kernels.cuh"

namespace alphascope::gpu {

struct OuterFaceFinder::State {
  WorkStream stream;
  DeviceBuffer<TriangleRange> ranges;  // by ball
  DeviceBuffer<FaceCode> owner, outside;
  DeviceBuffer<std::uint32_t> places;
  DeviceBuffer<unsigned char> scratch;
  PinnedBuffer<std::uint32_t> count;
  std::shared_ptr<ResultMemory> results = std::make_shared<ResultMemory>();

  void reserve(const DeviceComplex& complex) {
    ranges.reserve(complex.ball_count);
    owner.reserve(complex.triangles.count);
    outside.reserve(complex.triangles.count);
    places.reserve(complex.triangles.count + 1);
    count.reserve(1);
  }
  // Queues all work for `outside` and `count`.
  void enqueue(const DeviceComplex& complex) {
    const DeviceSimplices &triangles = complex.triangles, &tetrahedra = complex.tetrahedra;
    stream.fill(ranges, 0, complex.ball_count);
    stream.each(find_ranges, triangles.count, triangles, ranges.get());
    stream.each(find_owners, 4 * tetrahedra.count, triangles, tetrahedra, ranges.get(),
                owner.get());
    const IsRegular is_regular{triangles.classes, static_cast<std::uint32_t>(triangles.count)};
    prefix_sum(thrust::make_transform_iterator(thrust::make_counting_iterator(std::uint32_t{0}),
                                               is_regular),
               places.get(), triangles.count + 1, scratch, stream);
    stream.each(gather_owners, triangles.count, triangles, places.get(), owner.get(),
                outside.get());
    stream.fetch(count.get(), places.get() + triangles.count, 1);
  }
};

OuterFaceFinder::OuterFaceFinder() : state_(std::make_unique<State>()) {
  state_->stream.create();
}

// Waits, because queued work uses memory that is about to be freed.
OuterFaceFinder::~OuterFaceFinder() {
  cudaStreamSynchronize(state_->stream);
  state_->results->close();
}

std::optional<SharedFaces> OuterFaceFinder::find(const DeviceComplex& complex) {
  constexpr std::size_t kMostTriangles = std::numeric_limits<int>::max() - 1;
  constexpr std::size_t kMostFaces = std::numeric_limits<FaceCode>::max();
  if (complex.triangles.count > kMostTriangles || complex.tetrahedra.count > kMostFaces / 4) {
    return std::nullopt;
  }
  if (complex.tetrahedra.count == 0) return SharedFaces{};
  State& s = *state_;
  s.reserve(complex);
  s.enqueue(complex);
  s.stream.wait("looking for the outside");
  const std::size_t count = *s.count.get();
  const std::shared_ptr<unsigned char> memory = s.results->take(count * sizeof(FaceCode)).memory;
  const std::span<FaceCode> faces{reinterpret_cast<FaceCode*>(memory.get()), count};
  s.stream.fetch(faces.data(), s.outside.get(), count);
  s.stream.wait("copying the outside");
  return SharedFaces{memory, faces};
}

}  // namespace alphascope::gpu
