// SPDX-License-Identifier: GPL-3.0-or-later
// Enlarges the heap of glibc, and asks the kernel for large pages there.
#include "core/run/program_heap.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace alphascope {

void start_heap_on_large_pages() {
#if defined(MADV_HUGEPAGE) && defined(M_TOP_PAD)
  constexpr int kUsualStep = 128 << 10;  // bytes
  // Larger blocks get mappings of their own, so freeing them gives their memory back at once.
  // glibc raises this limit while a program runs, but no longer after a call of mallopt().
  constexpr int kLargestInHeap = 4 << 20;  // bytes; a texture of the view takes 2 MB at 1280x800
  mallopt(M_MMAP_THRESHOLD, kLargestInHeap);
  mallopt(M_TRIM_THRESHOLD, kHeapStartBytes);
  mallopt(M_TOP_PAD, kHeapStartBytes);
  const auto old_end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  // More than is free in the heap, so it grows. Volatile, or a compiler may leave out the pair.
  void* volatile const more = std::malloc(kLargestInHeap / 2);
  std::free(more);
  mallopt(M_TOP_PAD, kUsualStep);
  constexpr std::uintptr_t kPage = std::uintptr_t{2} << 20;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t begin = (old_end + kPage - 1) / kPage * kPage;
  if (begin >= end) return;  // the heap cannot grow
  static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
#endif
}

}  // namespace alphascope
