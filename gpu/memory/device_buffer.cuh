// SPDX-License-Identifier: GPL-3.0-or-later
// Device memory and pinned host memory that grows and is kept. Errors become exceptions.
#pragma once

#include <cuda_runtime.h>

#include <algorithm>
#include <new>
#include <string>

#include "core/engine/executor_failed.hpp"
#include "gpu/memory/device_allocation.hpp"
#include "gpu/memory/page_locked.hpp"

namespace alphascope::gpu {

// A CUDA call failed. Running out of memory is std::bad_alloc instead.
struct DeviceError : ExecutorFailed {
  using ExecutorFailed::ExecutorFailed;
};

inline void check(cudaError_t status, const char* what) {
  if (status == cudaSuccess) return;
  cudaGetLastError();  // clears the error, so that it is not reported again later
  if (status == cudaErrorMemoryAllocation) throw std::bad_alloc();
  throw DeviceError(std::string("the GPU failed while ") + what + ": " +
                    cudaGetErrorString(status));
}

// The spare bytes of a buffer that grows again. As alpha rises, nearly every run needs a little
// more, and reserving takes longer than the run. The spare is as much again, but at most 64 MB, or
// 32 MB for large buffers. Results of a million balls take up to 350 MB, and there are two or three
// of them.
inline std::size_t spare_bytes(std::size_t bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 26, kLarge = std::size_t{1} << 28;
  return std::min(bytes, bytes < kLarge ? kMost : kMost / 2);
}

// Calls reserve(bytes), with spare bytes added unless it is the first time. If there is not that
// much memory, calls it again without spare bytes. Returns the reserved size.
template <class Reserve>
std::size_t reserve_to_spare(std::size_t bytes, bool first, const char* what,
                             const Reserve& reserve) {
  const std::size_t more = first ? bytes : bytes + spare_bytes(bytes);
  if (reserve(more) == cudaSuccess) return more;
  cudaGetLastError();  // the second attempt reports the error
  check(reserve(bytes), what);
  return bytes;
}

// Uninitialised device memory. Growing loses the content.
template <class T>
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;
  ~DeviceBuffer() { free(); }
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    const bool first = capacity_ == 0;
    free();
    const auto allocate = [&](std::size_t bytes) {
      void* memory = nullptr;
      const cudaError_t status = allocate_device_memory(&memory, bytes);
      if (status == cudaSuccess) data_ = static_cast<T*>(memory);
      return status;
    };
    bytes_ = reserve_to_spare(count * sizeof(T), first, "reserving device memory", allocate);
    capacity_ = bytes_ / sizeof(T);
  }
  T* get() const { return data_; }
  std::size_t capacity() const { return capacity_; }

 private:
  void free() {
    free_device_memory(data_, bytes_);
    data_ = nullptr;
    bytes_ = capacity_ = 0;
  }

  T* data_ = nullptr;
  std::size_t bytes_ = 0;
  std::size_t capacity_ = 0;
};

// Pinned host memory. Copies to and from it run at full speed.
template <class T>
class PinnedBuffer {
 public:
  // Returns whether it grew.
  bool reserve(std::size_t count) {
    if (count <= capacity_) return false;
    const bool first = capacity_ == 0;
    memory_.free();
    capacity_ = 0;
    capacity_ = reserve_to_spare(count * sizeof(T), first, "reserving pinned host memory",
                                 [&](std::size_t bytes) { return memory_.allocate(bytes); }) /
                sizeof(T);
    return true;
  }
  T* get() const { return static_cast<T*>(memory_.get()); }
  std::size_t capacity() const { return capacity_; }

 private:
  PageLocked memory_;
  std::size_t capacity_ = 0;
};

}  // namespace alphascope::gpu
