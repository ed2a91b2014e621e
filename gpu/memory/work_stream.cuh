// SPDX-License-Identifier: GPL-3.0-or-later
// A stream with the calls that most work on a device needs, and a timer of its work.
#pragma once

#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"

namespace alphascope::gpu {

class WorkStream : public Stream {
 public:
  // One thread for each item.
  template <class Kernel, class... Arguments>
  void each(Kernel kernel, std::size_t items, const Arguments&... arguments) const {
    constexpr unsigned kEachThreads = 256;
    if (items == 0) return;
    launch(kernel,
           {static_cast<unsigned>((items + kEachThreads - 1) / kEachThreads), kEachThreads, *this},
           arguments...);
    check(cudaGetLastError(), "starting a kernel");
  }
  template <class T>
  void fill(const DeviceBuffer<T>& to, int byte, std::size_t count) const {
    check(cudaMemsetAsync(to.get(), byte, count * sizeof(T), *this), "clearing device memory");
  }
  template <class T>
  void send(const DeviceBuffer<T>& to, const void* from, std::size_t count) const {
    check(cudaMemcpyAsync(to.get(), from, count * sizeof(T), cudaMemcpyHostToDevice, *this),
          "copying to the device");
  }
  template <class T>
  void fetch(void* to, const T* from, std::size_t count) const {
    check(cudaMemcpyAsync(to, from, count * sizeof(T), cudaMemcpyDeviceToHost, *this),
          "copying to the host");
  }
  void wait(const char* what) const { check(cudaStreamSynchronize(*this), what); }
};

// Waits for the device before the memory that it uses is given away.
struct WaitAtEnd {
  const WorkStream &stream, &copier;
  ~WaitAtEnd() {
    cudaStreamSynchronize(stream);
    cudaStreamSynchronize(copier);
  }
};

// The time of the work that is queued between its construction and stop().
class DeviceTimer {
 public:
  explicit DeviceTimer(cudaStream_t stream) : stream_(stream) {
    begin_.create(cudaEventDefault);
    end_.create(cudaEventDefault);
    begin_.record(stream_);
  }
  void stop() { end_.record(stream_); }
  // Waits for the end of the work.
  double milliseconds() {
    check(cudaEventSynchronize(end_), "timing");
    float ms = 0;
    check(cudaEventElapsedTime(&ms, begin_, end_), "timing");
    return static_cast<double>(ms);
  }

 private:
  cudaStream_t stream_;
  Event begin_, end_;
};

}  // namespace alphascope::gpu
