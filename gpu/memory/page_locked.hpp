// Page-locked (pinned) host memory, which copies to and from a device run at full speed with.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>

namespace alphascope::gpu {

// One piece of it. Much of it is pages of our own where the system lets them be registered, large
// ones if there are any and first written by all threads: cudaMallocHost() gets small ones, one by
// one, and takes longer than most runs (docs/records/gpu-engine.md). What is less than a large page
// comes from memory that CUDA has at hand.
class PageLocked {
 public:
  PageLocked() = default;
  PageLocked(const PageLocked&) = delete;
  PageLocked& operator=(const PageLocked&) = delete;
  ~PageLocked() { free(); }

  // Uninitialised, and instead of what there was.
  cudaError_t allocate(std::size_t bytes);
  // As cudaFreeHost(), waits for all that the device has to do.
  void free();
  void* get() const { return data_; }

 private:
  void* data_ = nullptr;
  std::size_t own_bytes_ = 0;  // of pages of our own; 0: cudaMallocHost()'s
};

}  // namespace alphascope::gpu
