// SPDX-License-Identifier: GPL-3.0-or-later
// Tests picking of balls.
#include "ui/scene/pick/ball_pick.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

BallGeometry three_in_a_row() {
  BallGeometry balls;
  balls.centres = {{0, 0, -10}, {0, 0, -5}, {0, 0, 5}};
  balls.radii = {1, 1, 1};
  return balls;
}

// Picks in two ways, which must agree.
std::optional<std::size_t> picked(const BallGeometry& balls, const std::vector<float>& radii,
                                  const Ray& ray) {
  const auto one = pick_ball(balls, radii, ray);
  const BallPicker picker(std::make_shared<const BallGeometry>(balls));
  const auto other = picker.pick(radii, picker.margin(radii), ray);
  EXPECT_EQ(one.has_value(), other.has_value());
  if (!one || !other) return std::nullopt;
  EXPECT_EQ(one->ball, other->ball);
  EXPECT_EQ(one->depth, other->depth);
  return one->ball;
}

TEST(BallPick, TakesTheFirstBallAhead) {
  const BallGeometry balls = three_in_a_row();
  EXPECT_EQ(picked(balls, balls.radii, {{0, 0, 0}, {0, 0, -1}}), 1u);
  EXPECT_EQ(picked(balls, balls.radii, {{0, 0, 0}, {0, 0, 3}}), 2u);  // not of unit length
  EXPECT_EQ(picked(balls, balls.radii, {{0.5, 0.5, -7}, {0, 0, -1}}), 0u);
}

TEST(BallPick, MissesBesideBehindAndUndrawn) {
  const BallGeometry balls = three_in_a_row();
  EXPECT_FALSE(picked(balls, balls.radii, {{1.01, 0, 0}, {0, 0, -1}}));
  EXPECT_FALSE(picked(balls, balls.radii, {{0, 0, 20}, {0, 0, 1}}));
  EXPECT_EQ(picked(balls, {1, 0, 1}, {{0, 0, 0}, {0, 0, -1}}), 0u);
  EXPECT_FALSE(picked(balls, {}, {{0, 0, 0}, {0, 0, -1}}));
  EXPECT_FALSE(picked(BallGeometry(), {}, {}));
}

}  // namespace
}  // namespace alphascope
