// SPDX-License-Identifier: GPL-3.0-or-later
// Allocates memory that is aligned to large pages, asks the kernel to use them, and keeps what is
// freed.
#include "core/run/large_pages.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define ALPHASCOPE_ADDRESSES_CHECKED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ALPHASCOPE_ADDRESSES_CHECKED 1
#endif
#endif
#ifdef ALPHASCOPE_ADDRESSES_CHECKED
#include <sanitizer/asan_interface.h>
#endif

namespace alphascope {
namespace {

// Page size of x86-64 and of most arm64 systems.
constexpr std::size_t kPage = std::size_t{2} << 20;

// Bytes of whole pages. Only eight sizes between two powers of two occur, so an array of nearly the
// same size fits into memory that another one left.
std::size_t rounded(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::size_t>::max() / 2) throw std::bad_alloc();
  const std::size_t step = std::max(kPage, std::bit_floor(std::max<std::size_t>(bytes, 1)) / 8);
  return (bytes + step - 1) / step * step;
}

// A sanitizer takes a use of kept memory for one of freed memory.
void forbid_use([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef ALPHASCOPE_ADDRESSES_CHECKED
  ASAN_POISON_MEMORY_REGION(memory, bytes);
#endif
}
void allow_use([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef ALPHASCOPE_ADDRESSES_CHECKED
  ASAN_UNPOISON_MEMORY_REGION(memory, bytes);
#endif
}

// Memory of arrays that were freed.
class KeptMemory {
 public:
  // Null if no memory of this size is kept.
  void* take(std::size_t bytes) noexcept {
    const std::lock_guard lock(mutex_);
    for (Block& block : blocks_) {
      if (block.bytes != bytes) continue;
      kept_ -= bytes;
      allow_use(block.memory, bytes);
      return std::exchange(block, {}).memory;
    }
    return nullptr;
  }
  // Returns false if there is no place for it.
  bool keep(void* memory, std::size_t bytes) noexcept {
    const std::lock_guard lock(mutex_);
    if (bytes > kMostKeptBytes - kept_) return false;
    for (Block& block : blocks_) {
      if (block.memory != nullptr) continue;
      forbid_use(memory, bytes);
      kept_ += bytes;
      block = {memory, bytes};
      return true;
    }
    return false;
  }
  void free_all() noexcept {
    const std::lock_guard lock(mutex_);
    for (Block& block : blocks_) {
      allow_use(block.memory, block.bytes);
      std::free(std::exchange(block, {}).memory);
    }
    kept_ = 0;
  }

 private:
  struct Block {
    void* memory = nullptr;
    std::size_t bytes = 0;
  };
  std::mutex mutex_;
  std::array<Block, kMostKeptBytes / kLargeArrayBytes> blocks_{};
  std::size_t kept_ = 0;
};

// It is there before any array, and is not destroyed, since arrays may be freed at the very end.
constinit KeptMemory kept_memory;

}  // namespace

void* allocate_large(std::size_t bytes) {
  const std::size_t whole = rounded(bytes);
  if (void* const memory = kept_memory.take(whole)) return memory;
  void* memory = std::aligned_alloc(kPage, whole);
  if (memory == nullptr) {
    free_kept_large();
    memory = std::aligned_alloc(kPage, whole);
  }
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // This is a request; if the system refuses, pages have the usual size. The last incomplete page
  // is left out, since the rest of it will not be written.
  static_cast<void>(madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE));
#endif
  return memory;
}

void free_large(void* memory, std::size_t bytes) noexcept {
  if (!kept_memory.keep(memory, rounded(bytes))) std::free(memory);
}

void free_kept_large() noexcept {
  kept_memory.free_all();
}

}  // namespace alphascope
