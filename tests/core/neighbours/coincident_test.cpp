// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which of several balls with one centre are hidden.
#include "core/neighbours/coincident.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::random_int;

// By definition: among balls with one centre all are hidden but the first of the largest.
std::vector<bool> expected_hidden(const BallSet& balls) {
  std::map<std::tuple<int, int, int>, BallIndex> shown;
  std::vector<bool> hidden(balls.size(), false);
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const LatticePoint& c = balls.centres[i];
    const auto [at, is_new] = shown.insert({{c.x, c.y, c.z}, i});
    if (is_new) continue;
    const bool wins = balls.radii[i] > balls.radii[at->second];
    hidden[wins ? at->second : i] = true;
    if (wins) at->second = i;
  }
  return hidden;
}

TEST(CoincidentHidden, IsEmptyWhereNoneIs) {
  BallSet balls;
  EXPECT_TRUE(coincident_hidden(balls).empty());
  add_ball(balls, 1, 2, 3, 4);
  add_ball(balls, 1, 2, 4, 4);
  add_ball(balls, -1, 2, 3, 4);
  EXPECT_TRUE(coincident_hidden(balls).empty());
}

TEST(CoincidentHidden, LeavesTheFirstOfTheLargest) {
  BallSet balls;
  for (const int radius : {5, 7, 6, 7, 5}) add_ball(balls, 1, 2, 3, radius);
  add_ball(balls, 3, 2, 1, 1);
  EXPECT_EQ(coincident_hidden(balls), (std::vector<bool>{true, false, true, true, true, false}));
}

// Sets in few places and in many, which need several groups and runs.
TEST(CoincidentHidden, IsTheSameInSetsOfAnySize) {
  testing::Random random(11);
  for (const int extent : {0, 3, 40, 2000}) {
    for (const int size : {100, 9000, 200000}) {
      BallSet balls;
      for (int b = 0; b < size; ++b) {
        const auto coordinate = [&] { return random_int(random, -extent, extent); };
        add_ball(balls, coordinate(), coordinate(), coordinate(), random_int(random, 1, 5));
      }
      const std::vector<bool> hidden = coincident_hidden(balls), expected = expected_hidden(balls);
      const bool any = std::find(expected.begin(), expected.end(), true) != expected.end();
      EXPECT_EQ(hidden, any ? expected : std::vector<bool>{})
          << size << " balls, extent " << extent;
    }
  }
}

}  // namespace
}  // namespace alphascope
