// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the heap of a program on large pages.
#include "core/run/program_heap.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace alphascope {
namespace {

// The kernel's flags of the mapping that holds this address; "hg": large pages on request.
std::string flags_of(std::uintptr_t address) {
  std::ifstream maps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    std::istringstream words(line);
    if (words >> std::hex >> begin >> dash >> end && dash == '-') {
      inside = begin <= address && address < end;
    } else if (inside && line.rfind("VmFlags:", 0) == 0) {
      return line + " ";
    }
  }
  return "";
}

// In another process, because the change of the heap stays.
TEST(ProgramHeap, HasLargePages) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled")) {
    GTEST_SKIP() << "the system has no large pages";
  }
  const auto serve = [] {
    start_heap_on_large_pages();
    // Beyond the first large page, which begins with what the heap had before.
    constexpr std::size_t kSmall = 2'500'000, kLarge = 4'000'000;  // bytes
    for (const std::size_t bytes : {kSmall, kLarge}) {
      void* volatile const memory = std::malloc(bytes);
      const auto end = reinterpret_cast<std::uintptr_t>(memory) + bytes - 1;
      if (flags_of(end).find(" hg ") == std::string::npos) std::_Exit(1);
    }
    std::_Exit(0);
  };
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer has a heap of its own";
#elif defined(__has_feature)  // clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "a sanitizer has a heap of its own";
#endif
#endif
  EXPECT_EXIT(serve(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace alphascope
