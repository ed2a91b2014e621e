// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how the room of blocks follows the balls that found none.
#include "gpu/dual_edge/block_margin.hpp"

#include <gtest/gtest.h>

namespace alphascope::gpu {
namespace {

constexpr std::uint32_t kLimit = 10'000;

TEST(BlockMargin, GrowsWhereManyBallsFindNoRoom) {
  const double more = next_margin(kUsualMargin, kLimit / 2 + 1, 0, kLimit);
  EXPECT_GT(more, kUsualMargin);
  EXPECT_EQ(next_margin(more, kLimit / 2 + 1, 1, kLimit), more) << "long lists do not count";
  double margin = kUsualMargin;
  for (int run = 0; run < 20; ++run) margin = next_margin(margin, kLimit, 0, kLimit);
  EXPECT_EQ(margin, kMostMargin);
}

// Otherwise a set that needs much room at one alpha would keep it at all others.
TEST(BlockMargin, ComesBackWhereFewBallsAreLeft) {
  double margin = kMostMargin;
  for (int run = 0; run < 20; ++run) margin = next_margin(margin, kLimit / 8 - 1, 0, kLimit);
  EXPECT_EQ(margin, kUsualMargin);
}

TEST(BlockMargin, StaysInBetween) {
  for (const std::uint32_t deferred : {kLimit / 8, kLimit / 4, kLimit / 2}) {
    EXPECT_EQ(next_margin(1.5, deferred, 0, kLimit), 1.5);
  }
  EXPECT_EQ(next_margin(3, kLimit, 0, kLimit), 3) << "after a run that did not fit";
}

}  // namespace
}  // namespace alphascope::gpu
