// SPDX-License-Identifier: GPL-3.0-or-later
// Allocates page-locked memory from large pages, and registers it with CUDA.
#include "gpu/memory/page_locked.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "core/run/parallel.hpp"

namespace alphascope::gpu {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;

// New pages, all of them mapped; null if there is no memory.
unsigned char* new_pages(std::size_t bytes, std::size_t page) {
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  // A system without large pages refuses and uses small ones.
  madvise(memory, bytes, MADV_HUGEPAGE);
  madvise(memory, bytes, MADV_DONTFORK);  // fork() would have to copy pinned pages
  unsigned char* const pages = static_cast<unsigned char*>(memory);
  parallel_each(0, (bytes + kLargePage - 1) / kLargePage, [=](std::size_t piece) {
    const std::size_t end = std::min(bytes, (piece + 1) * kLargePage);
    for (std::size_t at = piece * kLargePage; at < end; at += page)
      static_cast<volatile unsigned char*>(pages)[at] = 0;
  });
  return pages;
}

}  // namespace

cudaError_t PageLocked::allocate(std::size_t bytes) {
  free();
  if (bytes == 0) return cudaSuccess;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t whole = (bytes + page - 1) / page * page;
  if (unsigned char* const pages = bytes < kLargePage ? nullptr : new_pages(whole, page)) {
    if (cudaHostRegister(pages, whole, cudaHostRegisterDefault) == cudaSuccess) {
      data_ = pages;
      own_bytes_ = whole;
      return cudaSuccess;
    }
    cudaGetLastError();  // not every system can register pages
    munmap(pages, whole);
  }
  return cudaMallocHost(&data_, bytes);
}

void PageLocked::free() {
  if (own_bytes_ > 0) {
    cudaDeviceSynchronize();
    cudaHostUnregister(data_);
    munmap(data_, own_bytes_);
  } else if (data_ != nullptr) {
    cudaFreeHost(data_);
  }
  data_ = nullptr;
  own_bytes_ = 0;
}

}  // namespace alphascope::gpu
