// SPDX-License-Identifier: GPL-3.0-or-later
// Tests memory on large pages.
#include "core/run/large_pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

namespace alphascope {
namespace {

TEST(LargePages, HoldAllThatIsAskedFor) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  for (const std::size_t bytes :
       {std::size_t{1}, kPage - 1, kPage, kPage + 1, kLargeArrayBytes, 5 * kPage + 12'345}) {
    auto* const memory = static_cast<char*>(allocate_large(bytes));
    ASSERT_NE(memory, nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % kPage, 0u) << "begins with a page";
    std::memset(memory, 0x5a, bytes);
    EXPECT_EQ(memory[0], 0x5a);
    EXPECT_EQ(memory[bytes - 1], 0x5a);
    free_large(memory, bytes);
  }
}

TEST(LargePages, AreUsedAgainForAboutTheSameSize) {
  constexpr std::size_t kBytes = 40'000'000;
  free_kept_large();
  void* const first = allocate_large(kBytes);
  void* const second = allocate_large(kBytes);
  EXPECT_NE(first, second);
  free_large(first, kBytes);
  EXPECT_EQ(allocate_large(kBytes - 1'000'000), first);
  void* const smaller = allocate_large(kBytes / 2);
  EXPECT_NE(smaller, second);
  free_large(first, kBytes - 1'000'000);
  free_large(second, kBytes);
  free_large(smaller, kBytes / 2);
  free_kept_large();
}

TEST(LargePages, KeepNoMoreThanTheLimit) {
  constexpr std::size_t kBytes = kMostKeptBytes / 4, kWritten = kBytes / 2;
  free_kept_large();
  std::array<char*, 6> memory{};
  const auto allocate = [&] {
    for (char*& m : memory) m = static_cast<char*>(allocate_large(kBytes));
  };
  const auto free_all = [&] {
    for (char* m : memory) free_large(m, kBytes);
  };
  allocate();
  for (char* m : memory) m[kWritten] = 1;
  free_all();
  allocate();
  // Pages that the system provides anew are zero.
  EXPECT_EQ(std::count_if(memory.begin(), memory.end(), [](char* m) { return m[kWritten] == 1; }),
            4);
  free_all();
  free_kept_large();
}

TEST(LargePages, RefuseWhatNoMachineHas) {
  // Beyond a page less, a sanitizer's allocator would end the program.
  for (const std::size_t less : {0, 1, 1'000'000}) {
    EXPECT_THROW(allocate_large(std::numeric_limits<std::size_t>::max() - less), std::bad_alloc);
  }
}

}  // namespace
}  // namespace alphascope
