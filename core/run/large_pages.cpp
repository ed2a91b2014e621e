// SPDX-License-Identifier: GPL-3.0-or-later
// Allocates memory that is aligned to large pages, and asks the kernel to use them.
#include "core/run/large_pages.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <limits>
#include <new>

namespace alphascope {

void* allocate_large(std::size_t bytes) {
  // Page size of x86-64 and of most arm64 systems.
  constexpr std::size_t kPage = std::size_t{2} << 20;
  if (bytes > std::numeric_limits<std::size_t>::max() - kPage) throw std::bad_alloc();
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  void* const memory = std::aligned_alloc(kPage, whole);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // This is a request; if the system refuses, pages have the usual size. The last incomplete page
  // is left out, since the rest of it will not be written.
  static_cast<void>(madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE));
#endif
  return memory;
}

void free_large(void* memory) noexcept {
  std::free(memory);
}

}  // namespace alphascope
