// SPDX-License-Identifier: GPL-3.0-or-later
// Tests arrays of results: ordinary ones, and those that adopt existing content.
#include "core/complex/simplices.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <numeric>

#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

class InPlace : public ::testing::Test {
 protected:
  InPlace() {
    std::iota(memory_->begin(), memory_->end(), 0.0f);
    array_ = in_place<float>(memory_, *memory_);
  }
  bool is_kept() const { return memory_.use_count() > 1; }
  static std::vector<float> numbers(const ResultArray<float>& array) {
    return {array.begin(), array.end()};
  }

  std::shared_ptr<std::vector<float>> memory_ = std::make_shared<std::vector<float>>(100);
  ResultArray<float> array_;
};

TEST_F(InPlace, HasTheContentWithoutACopy) {
  EXPECT_EQ(array_.data(), memory_->data());
  EXPECT_EQ(numbers(array_), *memory_);
}

TEST_F(InPlace, KeepsTheMemoryUntilItIsGone) {
  EXPECT_TRUE(is_kept());
  array_ = ResultArray<float>();
  EXPECT_FALSE(is_kept());
}

TEST_F(InPlace, CopiesHaveMemoryOfTheirOwn) {
  ResultArray<float> copy = array_;
  const ResultArray<float> assigned = [&] {
    ResultArray<float> to(3);
    to = array_;
    return to;
  }();
  EXPECT_NE(copy.data(), array_.data());
  array_ = ResultArray<float>();
  EXPECT_FALSE(is_kept());
  std::fill(memory_->begin(), memory_->end(), -1.0f);
  EXPECT_EQ(copy, assigned);
  EXPECT_EQ(copy[99], 99.0f);
}

TEST_F(InPlace, MovesAlong) {
  ResultArray<float> moved = std::move(array_);
  array_ = ResultArray<float>(5, 7.0f);
  EXPECT_EQ(moved.data(), memory_->data());
  std::swap(moved, array_);
  EXPECT_EQ(array_.data(), memory_->data());
  EXPECT_EQ(moved.size(), 5u);
  array_ = std::move(moved);
  EXPECT_EQ(array_[4], 7.0f);
  moved = ResultArray<float>();
  EXPECT_FALSE(is_kept());
}

TEST_F(InPlace, OutgrowsTheMemory) {
  array_.push_back(100);
  EXPECT_FALSE(is_kept());
  EXPECT_EQ(array_.size(), 101u);
  EXPECT_EQ(array_[100], 100.0f);
  EXPECT_EQ(array_[99], 99.0f);
}

TEST_F(InPlace, ShrinksIntoMemoryOfItsOwn) {
  array_.resize(10);
  EXPECT_TRUE(is_kept());
  array_.shrink_to_fit();
  EXPECT_NE(array_.data(), memory_->data());
  EXPECT_EQ(array_.size(), 10u);
  EXPECT_EQ(array_[9], 9.0f);
}

TEST_F(InPlace, NothingNeedsNoMemory) {
  array_ = in_place<float>(memory_, {});
  EXPECT_TRUE(array_.empty());
  array_.push_back(1);
  EXPECT_EQ(array_[0], 1.0f);
}

TEST(ResultArrays, AreEqualByTheirContent) {
  const auto memory = std::make_shared<std::vector<float>>(3, 1.0f);
  EXPECT_EQ(in_place<float>(memory, *memory), ResultArray<float>(3, 1.0f));
}

// Arrays of this size have another kind of memory.
TEST(LargeArray, GrowsAndIsCopiedAndMovedAsAnyOther) {
  constexpr std::size_t kSmall = 100, kLarge = 3 * kLargeArrayBytes / sizeof(std::uint32_t);
  ResultArray<std::uint32_t> array(kSmall);
  std::iota(array.begin(), array.end(), 0u);
  array.resize(kLarge);
  std::iota(array.begin() + kSmall, array.end(), std::uint32_t{kSmall});
  array.resize(kLarge + 1, 7u);
  ResultArray<std::uint32_t> copy = array;
  const ResultArray<std::uint32_t> moved = std::move(array);
  copy.resize(kSmall);
  copy.shrink_to_fit();
  EXPECT_EQ(copy.capacity(), kSmall);
  for (const std::size_t i : {std::size_t{0}, kSmall, kLarge - 1}) EXPECT_EQ(moved[i], i);
  EXPECT_EQ(moved[kLarge], 7u);
  EXPECT_EQ(copy[kSmall - 1], kSmall - 1);
}

TEST(LargeArray, SaysWhenThereIsNoSuchMemory) {
  EXPECT_THROW(allocate_large(~std::size_t{0}), std::bad_alloc);
  // AddressSanitizer ends the program at such a large request.
  if (testing::kAddressSanitizer) return;
  EXPECT_THROW(ResultArray<std::uint64_t>().resize(std::size_t{1} << 58), std::bad_alloc);
}

}  // namespace
}  // namespace alphascope
