#include "ui/scene/ball_pick.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

BallGeometry three_in_a_row() {
  BallGeometry balls;
  balls.centres = {{0, 0, -10}, {0, 0, -5}, {0, 0, 5}};
  balls.radii = {1, 1, 1};
  return balls;
}

TEST(BallPick, TakesTheFirstBallAhead) {
  const BallGeometry balls = three_in_a_row();
  EXPECT_EQ(pick_ball(balls, balls.radii, {{0, 0, 0}, {0, 0, -1}}), 1u);
  EXPECT_EQ(pick_ball(balls, balls.radii, {{0, 0, 0}, {0, 0, 3}}), 2u);  // not unit length
  EXPECT_EQ(pick_ball(balls, balls.radii, {{0.5, 0.5, -7}, {0, 0, -1}}), 0u);
}

TEST(BallPick, MissesBesideBehindAndUndrawn) {
  const BallGeometry balls = three_in_a_row();
  EXPECT_FALSE(pick_ball(balls, balls.radii, {{1.01, 0, 0}, {0, 0, -1}}));
  EXPECT_FALSE(pick_ball(balls, balls.radii, {{0, 0, 20}, {0, 0, 1}}));
  EXPECT_EQ(pick_ball(balls, {1, 0, 1}, {{0, 0, 0}, {0, 0, -1}}), 0u);
  EXPECT_FALSE(pick_ball(balls, {}, {{0, 0, 0}, {0, 0, -1}}));
  EXPECT_FALSE(pick_ball(BallGeometry(), {}, {}));
}

}  // namespace
}  // namespace alphascope
