// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the space that centres span: a point, a line, a plane or all of space.
#include "core/predicates/spanning_balls.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

TEST(SpanningBalls, AreTheFirstThatAreNotInTheSpanOfThoseBefore) {
  BallSet balls;
  EXPECT_EQ(dimension_of_centres(balls), -1);
  testing::add_ball(balls, 5, 5, 5, 1);
  EXPECT_EQ(dimension_of_centres(balls), 0);
  testing::add_ball(balls, 5, 5, 5, 3);  // the same place
  EXPECT_EQ(spanning_balls(balls, 0), (Balls{0}));
  EXPECT_EQ(dimension_of_centres(balls), 0);
  testing::add_ball(balls, 7, 6, 5, 1);
  testing::add_ball(balls, 11, 8, 5, 1);  // on one line
  EXPECT_EQ(spanning_balls(balls, 0), (Balls{0, 2}));
  EXPECT_EQ(dimension_of_centres(balls), 1);
  testing::add_ball(balls, 5, 9, 5, 1);
  testing::add_ball(balls, -20, 31, 5, 1);  // in one plane
  EXPECT_EQ(spanning_balls(balls, 0), (Balls{0, 2, 4}));
  EXPECT_EQ(dimension_of_centres(balls), 2);
  testing::add_ball(balls, 0, 0, 6, 1);
  testing::add_ball(balls, 0, 0, 9, 1);
  EXPECT_EQ(spanning_balls(balls, 0), (Balls{0, 2, 4, 6}));
  EXPECT_EQ(dimension_of_centres(balls), 3);
  EXPECT_EQ(spanning_balls(balls, 3), (Balls{3, 0, 4, 6})) << "from another ball";
}

// A ball one lattice unit off a line, or off a plane, as long as the lattice allows.
TEST(SpanningBalls, OneUnitIsBeyond) {
  for (const int off : {0, 1}) {
    BallSet balls;
    testing::add_ball(balls, -kMaxLatticeCoordinate, 0, 0, 1);
    testing::add_ball(balls, kMaxLatticeCoordinate, 0, 0, 1);
    testing::add_ball(balls, 0, off, 0, 1);
    EXPECT_EQ(dimension_of_centres(balls), 1 + off);
    testing::add_ball(balls, 0, kMaxLatticeCoordinate, 0, 1);
    testing::add_ball(balls, 1, -kMaxLatticeCoordinate, off, 1);
    EXPECT_EQ(dimension_of_centres(balls), 2 + off);
  }
}

}  // namespace
}  // namespace alphascope
