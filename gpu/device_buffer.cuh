// Device and pinned host memory that grows and is kept; errors as exceptions.
#pragma once

#include <cuda_runtime.h>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "gpu/faults.hpp"

namespace alphascope::gpu {

// A CUDA call failed. Running out of memory is std::bad_alloc instead.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void check(cudaError_t status, const char* what) {
  if (Faults::lost()) status = cudaErrorDevicesUnavailable;
  if (status == cudaSuccess) return;
  cudaGetLastError();  // the error is reported here; do not report it again later
  if (status == cudaErrorMemoryAllocation) throw std::bad_alloc();
  throw DeviceError(std::string("the GPU failed while ") + what + ": " +
                    cudaGetErrorString(status));
}

// Uninitialised device memory; growing loses the content.
template <class T>
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;
  ~DeviceBuffer() { cudaFree(data_); }
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    cudaFree(data_);
    data_ = nullptr;
    capacity_ = 0;
    if (Faults::refuses()) throw std::bad_alloc();
    check(cudaMalloc(&data_, count * sizeof(T)), "reserving device memory");
    capacity_ = count;
  }
  T* get() const { return data_; }
  std::size_t capacity() const { return capacity_; }

 private:
  T* data_ = nullptr;
  std::size_t capacity_ = 0;
};

// Pinned host memory: copies to and from it run at full speed.
template <class T>
class PinnedBuffer {
 public:
  PinnedBuffer() = default;
  PinnedBuffer(const PinnedBuffer&) = delete;
  PinnedBuffer& operator=(const PinnedBuffer&) = delete;
  ~PinnedBuffer() { cudaFreeHost(data_); }
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    cudaFreeHost(data_);
    data_ = nullptr;
    capacity_ = 0;
    if (Faults::refuses()) throw std::bad_alloc();
    check(cudaMallocHost(&data_, count * sizeof(T)), "reserving pinned host memory");
    capacity_ = count;
  }
  T* get() const { return data_; }
  // The caller's from now on, for cudaFreeHost().
  T* release() {
    capacity_ = 0;
    return std::exchange(data_, nullptr);
  }

 private:
  T* data_ = nullptr;
  std::size_t capacity_ = 0;
};

}  // namespace alphascope::gpu
