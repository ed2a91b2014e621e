// SPDX-License-Identifier: GPL-3.0-or-later
// Tests memory on large pages.
#include "core/run/large_pages.hpp"

#include <gtest/gtest.h>

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
    free_large(memory);
  }
}

TEST(LargePages, RefuseWhatNoMachineHas) {
  // Beyond a page less, a sanitizer's allocator would end the program.
  for (const std::size_t less : {0, 1, 1'000'000}) {
    EXPECT_THROW(allocate_large(std::numeric_limits<std::size_t>::max() - less), std::bad_alloc);
  }
}

}  // namespace
}  // namespace alphascope
