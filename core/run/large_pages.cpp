// See the header.
#include "core/run/large_pages.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <limits>
#include <new>

namespace alphascope {

void* allocate_large(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{2} << 20;  // x86-64's and most of arm64's
  if (bytes > std::numeric_limits<std::size_t>::max() - kPage) throw std::bad_alloc();
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  void* const memory = std::aligned_alloc(kPage, whole);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // A wish: where it is not granted, pages are as usual. What is left of the last one stays so, for
  // nobody will write there.
  static_cast<void>(madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE));
#endif
  return memory;
}

void free_large(void* memory) noexcept {
  std::free(memory);
}

}  // namespace alphascope
