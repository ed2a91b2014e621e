// SPDX-License-Identifier: GPL-3.0-or-later
// The CUDA executor of core/tuples/tuple_pipeline.hpp: streams, staging memory, textures and
// events.
#pragma once

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>
#include <cub/device/device_reduce.cuh>
#include <cub/device/device_scan.cuh>

#include <array>
#include <chrono>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <memory_resource>
#include <type_traits>
#include <vector>

#include "core/tuples/tuple_pipeline.hpp"
#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/tuples/tuple_kernels.cuh"

namespace alphascope::gpu {

// Page-locked host memory for the arrays of the grid.
class PinnedMemory : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t) override {
    auto buffer = std::make_unique<PinnedBuffer<char>>();
    buffer->reserve(std::max<std::size_t>(bytes, 1));
    void* const data = buffer->get();
    buffers_[data] = std::move(buffer);
    return data;
  }
  void do_deallocate(void* data, std::size_t, std::size_t) override { buffers_.erase(data); }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::map<void*, std::unique_ptr<PinnedBuffer<char>>> buffers_;
};

// Pinned or pageable bytes that grow and are kept.
class StagingBuffer {
 public:
  explicit StagingBuffer(bool pinned) : pinned_(pinned) {}
  void* reserve(std::size_t bytes) {
    if (pinned_) {
      page_locked_.reserve(bytes);
      return page_locked_.get();
    }
    if (pageable_.size() < bytes) pageable_.resize(bytes);
    return pageable_.data();
  }

 private:
  const bool pinned_;
  PinnedBuffer<char> page_locked_;
  std::vector<char> pageable_;
};

class TextureObject {
 public:
  TextureObject() = default;
  TextureObject(const TextureObject&) = delete;
  TextureObject& operator=(const TextureObject&) = delete;
  ~TextureObject() { release(); }
  // Binds the texture to `count` elements of linear device memory.
  template <class T>
  cudaTextureObject_t bind(const T* data, std::size_t count) {
    release();
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypeLinear;
    resource.res.linear.devPtr = const_cast<T*>(data);
    resource.res.linear.desc =
        cudaCreateChannelDesc<std::conditional_t<std::is_same_v<T, BallRecord>, int4, T>>();
    resource.res.linear.sizeInBytes = count * sizeof(T);
    cudaTextureDesc texture{};
    texture.readMode = cudaReadModeElementType;
    check(cudaCreateTextureObject(&object_, &resource, &texture, nullptr), "making a texture");
    return object_;
  }

 private:
  void release() {
    if (object_ != 0) cudaDestroyTextureObject(object_);
    object_ = 0;
  }
  cudaTextureObject_t object_ = 0;
};

// Reader_ is PlainReader or TextureReader. Must not be used by two threads at once.
template <class Reader_>
class CudaTupleExecutor {
 public:
  using Reader = Reader_;
  template <class T>
  using Buffer = DeviceBuffer<T>;
  static constexpr bool kOnGpu = true;

  explicit CudaTupleExecutor(const TupleOptions& options);
  CudaTupleExecutor(const CudaTupleExecutor&) = delete;
  CudaTupleExecutor& operator=(const CudaTupleExecutor&) = delete;

  std::uint64_t capacity() const { return capacity_; }
  std::size_t workers() const { return options_.streams > 1 ? options_.streams : 1; }
  std::pmr::memory_resource* host_memory() {
    return options_.pinned ? &pinned_memory_ : std::pmr::new_delete_resource();
  }
  TupleUpload<Reader> upload(const TupleGrid& grid);

  template <class Body>
  void for_each(int lane, std::uint64_t count, const Body& body) {
    if (count == 0) return;
    const auto blocks =
        std::min<std::uint64_t>((count + kTupleThreads - 1) / kTupleThreads, 1 << 20);
    launch(run_for_each<Body>, {static_cast<unsigned>(blocks), kTupleThreads, stream(lane)}, body,
           count);
    check(cudaGetLastError(), "starting a kernel");
  }
  template <class Body>
  void for_each_of(int lane, const std::uint64_t* count, std::uint64_t most, const Body& body) {
    if (most == 0) return;
    const auto blocks =
        std::min<std::uint64_t>((most + kTupleThreads - 1) / kTupleThreads, 8 * multiprocessors_);
    launch(run_for_each_of<Body>, {static_cast<unsigned>(blocks), kTupleThreads, stream(lane)},
           body, count);
    check(cudaGetLastError(), "starting a kernel");
  }
  template <class Value>
  void prefix_sum(int lane, std::uint64_t count, const Value& value, std::uint64_t* sums) {
    const auto values = padded(value, count);
    std::size_t bytes = 0;
    check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, values, sums, count + 1, stream(lane)),
          "sizing a prefix sum");
    check(cub::DeviceScan::ExclusiveSum(scratch(lane, bytes), bytes, values, sums, count + 1,
                                        stream(lane)),
          "a prefix sum");
  }
  template <class Value>
  std::uint64_t sum(int lane, std::uint64_t count, const Value& value) {
    const auto values = padded(value, count);
    total_.reserve(1);
    std::size_t bytes = 0;
    check(cub::DeviceReduce::Sum(nullptr, bytes, values, total_.get(), count, stream(lane)),
          "sizing a sum");
    check(cub::DeviceReduce::Sum(scratch(lane, bytes), bytes, values, total_.get(), count,
                                 stream(lane)),
          "a sum");
    return read(lane, total_.get());
  }
  template <class T>
  T read(int lane, const T* from) {
    // Memory that outlives the copy even after an exception.
    T* value = static_cast<T*>(lanes_[static_cast<std::size_t>(lane)].value->reserve(sizeof(T)));
    check(cudaMemcpyAsync(value, from, sizeof(T), cudaMemcpyDeviceToHost, stream(lane)),
          "copying a count");
    check(cudaStreamSynchronize(stream(lane)), "running the tuple kernels");
    return *value;
  }
  template <class T>
  void fetch(int lane, const T* from, std::uint64_t count, ResultArray<T>& to) {
    Lane& l = lanes_[static_cast<std::size_t>(lane)];
    if (l.pending.size() == l.staging.size())
      l.staging.emplace_back(std::make_unique<StagingBuffer>(options_.pinned));
    const std::size_t bytes = count * sizeof(T);
    T* staged = static_cast<T*>(l.staging[l.pending.size()]->reserve(bytes));
    check(cudaMemcpyAsync(staged, from, bytes, cudaMemcpyDeviceToHost, stream(lane)),
          "copying simplices");
    l.pending.push_back([staged, count, &to] { to.insert(to.end(), staged, staged + count); });
  }
  void wait(int lane);
  void reset();
  void begin(int lane, std::string_view stage);
  void end(int lane);
  // Sums over all launches and copies. Those of several streams overlap, so their sum exceeds the
  // wall time.
  StageTimes take_times();

 private:
  using Clock = std::chrono::steady_clock;
  struct Lane {
    std::vector<std::unique_ptr<StagingBuffer>> staging;
    std::vector<std::function<void()>> pending;
    DeviceBuffer<unsigned char> scratch;
    std::unique_ptr<StagingBuffer> value;
  };
  struct Interval {
    int lane;
    std::string_view stage;
    Event start, end;
  };

  cudaStream_t stream(int lane) const {
    return streams_[options_.streams > 1 ? static_cast<std::size_t>(lane) : 0];
  }
  void* scratch(int lane, std::size_t bytes) {
    // At least one byte, because CUB takes a null pointer as the question how much it needs.
    DeviceBuffer<unsigned char>& s = lanes_[static_cast<std::size_t>(lane)].scratch;
    s.reserve(std::max<std::size_t>(bytes, 1));
    return s.get();
  }
  template <class Value>
  static auto padded(const Value& value, std::uint64_t count) {
    return thrust::make_transform_iterator(thrust::make_counting_iterator(std::uint64_t{0}),
                                           PaddedValue<Value>{value, count});
  }
  template <class T>
  void copy_in(const std::pmr::vector<T>& from, DeviceBuffer<T>& to);
  void copy_all_in(const TupleGrid& grid);
  Event event();
  void add_time(std::string_view stage, double milliseconds);
  void collect_intervals();
  void give_back_intervals();

  // Number of tuples in a batch. It fills the largest device and takes about 100 MB for each
  // stream.
  static constexpr std::uint64_t kTuplesPerBatch = std::uint64_t{1} << 21;
  static constexpr std::size_t kMostIntervals = 512;

  const TupleOptions options_;
  const std::uint64_t capacity_;
  std::uint64_t multiprocessors_ = 1;
  PinnedMemory pinned_memory_;
  std::vector<Stream> streams_;
  std::vector<Lane> lanes_;
  DeviceBuffer<BallRecord> records_;
  DeviceBuffer<float> reach_;
  DeviceBuffer<std::uint32_t> ball_, cell_start_;
  DeviceBuffer<std::uint64_t> total_;
  TextureObject record_texture_, reach_texture_;
  std::vector<Interval> intervals_;
  std::vector<Event> free_events_;
  StageTimes times_;
};

template <class R>
CudaTupleExecutor<R>::CudaTupleExecutor(const TupleOptions& options)
    : options_(options),
      capacity_(options.tuples_per_batch > 0 ? options.tuples_per_batch : kTuplesPerBatch),
      streams_(options.streams > 1 ? workers() + 1 : 1),
      lanes_(workers() + 1) {
  int device = 0, count = 0;
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaDeviceGetAttribute(&count, cudaDevAttrMultiProcessorCount, device),
        "asking for its processors");
  multiprocessors_ = static_cast<std::uint64_t>(count);
  for (Stream& s : streams_) s.create();
  for (Lane& l : lanes_) l.value = std::make_unique<StagingBuffer>(options.pinned);
}

// Copies one piece per stream, so that copies of several streams overlap.
template <class R>
template <class T>
void CudaTupleExecutor<R>::copy_in(const std::pmr::vector<T>& from, DeviceBuffer<T>& to) {
  to.reserve(from.size());
  const std::size_t pieces = streams_.size();
  for (std::size_t p = 0; p < pieces; ++p) {
    const std::size_t begin = from.size() * p / pieces, end = from.size() * (p + 1) / pieces;
    if (begin == end) continue;
    check(cudaMemcpyAsync(to.get() + begin, from.data() + begin, (end - begin) * sizeof(T),
                          cudaMemcpyHostToDevice, streams_[p]),
          "copying the balls");
  }
}

template <class R>
void CudaTupleExecutor<R>::copy_all_in(const TupleGrid& grid) {
  try {
    copy_in(grid.records, records_);
    copy_in(grid.reach, reach_);
    copy_in(grid.ball, ball_);
    copy_in(grid.cell_start, cell_start_);
    for (const Stream& s : streams_) check(cudaStreamSynchronize(s), "copying the balls");
  } catch (...) {  // the grid may be destroyed before its copies are done
    for (const Stream& s : streams_) cudaStreamSynchronize(s);
    throw;
  }
}

// The host takes this time, because the driver copies pageable memory through its own buffers on
// the host.
template <class R>
TupleUpload<R> CudaTupleExecutor<R>::upload(const TupleGrid& grid) {
  const Clock::time_point start = Clock::now();
  copy_all_in(grid);
  TupleUpload<R> result{{}, cell_start_.get(), ball_.get()};
  if constexpr (std::is_same_v<R, TextureReader>) {
    result.read = {record_texture_.bind(records_.get(), grid.records.size()),
                   reach_texture_.bind(reach_.get(), grid.reach.size())};
  } else {
    result.read = {records_.get(), reach_.get()};
  }
  add_time(stage::kHostToDevice,
           std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  return result;
}

template <class R>
void CudaTupleExecutor<R>::wait(int lane) {
  check(cudaStreamSynchronize(stream(lane)), "running the tuple kernels");
  Lane& l = lanes_[static_cast<std::size_t>(lane)];
  const Clock::time_point start = Clock::now();
  for (const auto& append : l.pending) append();
  if (!l.pending.empty()) {
    add_time(stage::kDeviceToHost,
             std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  l.pending.clear();
  if (intervals_.size() > kMostIntervals) collect_intervals();
}

template <class R>
void CudaTupleExecutor<R>::reset() {
  for (const Stream& s : streams_) check(cudaStreamSynchronize(s), "ending earlier work");
  for (Lane& l : lanes_) l.pending.clear();
  give_back_intervals();
  times_ = {};
}

template <class R>
Event CudaTupleExecutor<R>::event() {
  Event e;
  if (free_events_.empty()) {
    e.create(cudaEventDefault);
  } else {
    e = std::move(free_events_.back());
    free_events_.pop_back();
  }
  return e;
}

template <class R>
void CudaTupleExecutor<R>::begin(int lane, std::string_view stage) {
  intervals_.push_back({lane, stage, event(), {}});
  intervals_.back().start.record(stream(lane));
}

template <class R>
void CudaTupleExecutor<R>::end(int lane) {
  Interval& i = intervals_.back();  // begin() and end() come in pairs
  i.end = event();
  i.end.record(stream(lane));
}

template <class R>
void CudaTupleExecutor<R>::add_time(std::string_view stage, double milliseconds) {
  for (StageTime& s : times_.stages) {
    if (s.label == stage) {
      s.milliseconds += milliseconds;
      return;
    }
  }
  times_.stages.push_back({std::string(stage), milliseconds, false});
}

// Waits for all intervals and adds up their times.
template <class R>
void CudaTupleExecutor<R>::collect_intervals() {
  for (const Interval& i : intervals_) {
    check(cudaEventSynchronize(i.end), "waiting for an event");
    float milliseconds = 0;
    check(cudaEventElapsedTime(&milliseconds, i.start, i.end), "reading an event");
    add_time(i.stage, milliseconds);
  }
  give_back_intervals();
}

template <class R>
void CudaTupleExecutor<R>::give_back_intervals() {
  for (Interval& i : intervals_) {
    free_events_.push_back(std::move(i.start));
    if (i.end != nullptr) free_events_.push_back(std::move(i.end));
  }
  intervals_.clear();
}

template <class R>
StageTimes CudaTupleExecutor<R>::take_times() {
  collect_intervals();
  // The list of stages ends with the copies to the host, although these began while kernels still
  // ran.
  std::stable_partition(times_.stages.begin(), times_.stages.end(),
                        [](const StageTime& s) { return s.label != stage::kDeviceToHost; });
  return std::move(times_);
}

}  // namespace alphascope::gpu
