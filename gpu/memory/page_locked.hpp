// SPDX-License-Identifier: GPL-3.0-or-later
// Page-locked (pinned) host memory, with which copies to and from a device run at full speed.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>

namespace alphascope::gpu {

// One piece of such memory. Large pieces are pages of our own, registered with CUDA if the system
// allows it. They are large pages if possible, and all threads write them first. By contrast,
// cudaMallocHost() gets small pages one by one and takes longer than most runs
// (docs/records/gpu-engine.md). Pieces below a large page come from CUDA's own memory.
class PageLocked {
 public:
  PageLocked() = default;
  PageLocked(const PageLocked&) = delete;
  PageLocked& operator=(const PageLocked&) = delete;
  ~PageLocked() { free(); }

  // Allocates uninitialised memory in place of the previous piece.
  cudaError_t allocate(std::size_t bytes);
  // Waits for all work of the device, as cudaFreeHost() does.
  void free();
  void* get() const { return data_; }

 private:
  void* data_ = nullptr;
  std::size_t own_bytes_ = 0;  // size of pages of our own; 0: from cudaMallocHost()
};

}  // namespace alphascope::gpu
