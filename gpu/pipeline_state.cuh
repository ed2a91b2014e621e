// What the runs for one set of balls share: device buffers, the plan of the grid, event timing.
// Included by the pipeline's sources only.
#pragma once

#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "gpu/device_buffer.cuh"
#include "gpu/facet_pipeline.hpp"
#include "gpu/problem.cuh"

namespace alphascope::gpu {

inline constexpr int kThreads = 256;

inline unsigned blocks_for(std::size_t items) {
  return static_cast<unsigned>((items + kThreads - 1) / kThreads);
}

// Below 2^24, by what the margins of the neighbour search may add: differences of neighbours stay
// exact in single precision and within the double brackets.
inline constexpr double kMaxCutoff = 16.7e6;

// Start values of what is afterwards sized by counting: a list that is too short, or a staging
// area, is noticed by the kernel and the run repeated with what it needed.
inline constexpr int kFirstList = 32;
inline constexpr int kFirstStaging = 12;  // a ball of the block
inline constexpr int kMaxList = 4095;     // 12 bits of a staging key

// Counters of one run, together so that one copy brings them back.
struct Counters {
  std::uint32_t cursor[3];
  std::uint32_t exact_count, needed_list, needed_staging, failures, padding;
  BlockStatistics blocks;  // of a tetrahedra run
};

inline constexpr std::size_t kCounterWords = sizeof(Counters) / 4;

// The device-side buffers of one dimension.
struct DimensionBuffers {
  DeviceBuffer<std::uint32_t> vertices, ordered;
  DeviceBuffer<float> value, ordered_value;
  DeviceBuffer<std::uint8_t> simplex_class, ordered_class;
  DeviceBuffer<std::uint32_t> start, count, offset;
  PinnedBuffer<std::uint32_t> host_vertices;
  PinnedBuffer<float> host_value;
  PinnedBuffer<std::uint8_t> host_class;

  // How many fit; the vertices alone may have grown for an earlier request without values.
  std::size_t simplices(int n, bool values) const {
    return values ? std::min(vertices.capacity() / n, value.capacity()) : vertices.capacity() / n;
  }
  void reserve(std::size_t simplices, int n, bool values) {
    vertices.reserve(simplices * n);
    ordered.reserve(simplices * n);
    if (!values) return;
    value.reserve(simplices);
    ordered_value.reserve(simplices);
    simplex_class.reserve(simplices);
    ordered_class.reserve(simplices);
  }
};

class EventTimer {
 public:
  EventTimer(cudaStream_t stream, StageTimes* times) : stream_(stream), times_(times) {
    if (times_ == nullptr) return;
    for (cudaEvent_t& e : events_) check(cudaEventCreate(&e), "creating an event");
    check(cudaEventRecord(events_[0], stream_), "recording an event");
  }
  ~EventTimer() {
    if (times_ == nullptr) return;
    for (const cudaEvent_t& e : events_) cudaEventDestroy(e);
  }
  void mark(std::string_view label) {
    if (times_ == nullptr) return;
    labels_.push_back(label);
    check(cudaEventRecord(events_[labels_.size()], stream_), "recording an event");
  }
  // After the stream has finished.
  void report() {
    if (times_ == nullptr) return;
    for (std::size_t s = 0; s < labels_.size(); ++s) {
      float milliseconds = 0;
      check(cudaEventElapsedTime(&milliseconds, events_[s], events_[s + 1]), "reading an event");
      times_->stages.push_back({std::string(labels_[s]), milliseconds, false});
    }
  }
  void restart() {
    labels_.clear();
    if (times_ != nullptr) check(cudaEventRecord(events_[0], stream_), "recording an event");
  }

 private:
  cudaStream_t stream_;
  StageTimes* times_;
  cudaEvent_t events_[16] = {};
  std::vector<std::string_view> labels_;
};

// The buffers of one set of balls, kept from run to run, and what earlier runs needed.
struct FacetPipeline::State {
  cudaStream_t stream = nullptr;
  std::size_t n = 0;
  LatticePoint low, high;
  std::int32_t max_radius = 0;
  // What earlier whole runs needed, by alpha: the longest neighbour list and the fullest staging
  // area.
  struct Need {
    double alpha;
    int list, staging;
  };
  std::vector<Need> needs;
  // The same for tetrahedra runs.
  struct TetrahedraNeed {
    double alpha;
    int balls_per_block;
    BlockRoom block, ball;  // of kernel II's blocks, and of kernel III's, which take one ball
    std::size_t tetrahedra;
    double margin;  // over the mean room
  };
  std::vector<TetrahedraNeed> tetrahedra_needs;
  int shared_limit = 0, multiprocessors = 1;

  PinnedBuffer<int4> host_balls;
  PinnedBuffer<Counters> host_counters;
  DeviceBuffer<int4> balls, sorted;
  DeviceBuffer<uint2> cell_and_rank;
  DeviceBuffer<std::uint32_t>
      zeroed;  // Counters, then the cells' counts, then the balls' tetrahedra
  DeviceBuffer<std::uint32_t> index, cell, cell_start, exact_list;
  DeviceBuffer<float4> near;
  DeviceBuffer<std::uint8_t> vertex_state;
  DeviceBuffer<std::uint32_t> flags, nearest, present;
  DeviceBuffer<unsigned char> scratch;
  DimensionBuffers dimension[4];  // vertices, edges, triangles, tetrahedra

  Counters* counters() { return reinterpret_cast<Counters*>(zeroed.get()); }

  ~State() {
    if (stream != nullptr) cudaStreamDestroy(stream);
  }

  // The need of the nearest alpha not below this one; less alpha never needs more.
  Need expected_need(double alpha) const {
    Need best{alpha, kFirstList, kFirstStaging};
    bool found = false;
    for (const Need& n : needs) {
      if (n.alpha < alpha || (found && n.alpha >= best.alpha)) continue;
      best = n;
      found = true;
    }
    if (!found) {
      for (const Need& n : needs) {
        if (n.list > best.list) best = {alpha, n.list, n.staging};
      }
    }
    return best;
  }
  void note_need(const Need& need) {
    for (Need& n : needs) {
      if (n.alpha == need.alpha) {
        n = need;
        return;
      }
    }
    if (needs.size() >= 64) needs.erase(needs.begin());
    needs.push_back(need);
  }

  // The grid for this alpha, with its buffers; nothing when differences would not be exact.
  std::optional<Problem> plan(double alpha);
  SortedBalls sort_into_cells(const Problem& p, EventTimer& timer);
  PipelineResult run_tetrahedra(double alpha, const CancelToken& cancel, StageTimes* times);
  PipelineResult run_whole(double alpha, const CancelToken& cancel, StageTimes* times);

  void scan(const std::uint32_t* in, std::uint32_t* out, std::size_t count) {
    std::size_t bytes = 0;
    check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, in, out, static_cast<int>(count), stream),
          "sizing a prefix sum");
    scratch.reserve(bytes);
    check(cub::DeviceScan::ExclusiveSum(scratch.get(), bytes, in, out, static_cast<int>(count),
                                        stream),
          "a prefix sum");
  }
  void zero(void* data, std::size_t bytes) {
    check(cudaMemsetAsync(data, 0, bytes, stream), "clearing device memory");
  }
  template <int N>
  DeviceSimplices<N> device_simplices(bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    return {d.vertices.get(),
            whole ? d.value.get() : nullptr,
            whole ? d.simplex_class.get() : nullptr,
            static_cast<std::uint32_t>(d.simplices(N, whole)),
            &counters()->cursor[N - 2],
            d.start.get(),
            d.count.get()};
  }
  template <int N>
  void order(bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    scan(d.count.get(), d.offset.get(), n);
    place<N><<<4 * multiprocessors, kThreads, 0, stream>>>(
        device_simplices<N>(whole), d.offset.get(), d.ordered.get(),
        whole ? d.ordered_value.get() : nullptr, whole ? d.ordered_class.get() : nullptr);
  }
  // Brings `count` simplices to the host.
  template <int N>
  HostSimplices<N> fetch(std::size_t count, bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    d.host_vertices.reserve(count * N + count * N / 8);
    check(cudaMemcpyAsync(d.host_vertices.get(), d.ordered.get(), count * N * 4,
                          cudaMemcpyDeviceToHost, stream),
          "copying simplices");
    HostSimplices<N> result;
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(std::uint32_t));
    result.simplices = {reinterpret_cast<const std::array<BallIndex, N>*>(d.host_vertices.get()),
                        count};
    if (whole) {
      d.host_value.reserve(count + count / 8);
      d.host_class.reserve(count + count / 8);
      check(cudaMemcpyAsync(d.host_value.get(), d.ordered_value.get(), count * 4,
                            cudaMemcpyDeviceToHost, stream),
            "copying alpha values");
      check(cudaMemcpyAsync(d.host_class.get(), d.ordered_class.get(), count,
                            cudaMemcpyDeviceToHost, stream),
            "copying classes");
      result.values = {d.host_value.get(), count};
      result.classes = {reinterpret_cast<const SimplexClass*>(d.host_class.get()), count};
    }
    return result;
  }
};

}  // namespace alphascope::gpu
