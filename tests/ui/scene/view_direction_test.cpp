// SPDX-License-Identifier: GPL-3.0-or-later
// Tests views from another side: no turn leaves the camera below the molecule or upside down.
#include "ui/scene/view_direction.hpp"
#include "core/geometry/alpha.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

double along(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A view of the origin along -z from 20 Å, with y upwards.
ViewFrustum level_sight() {
  ViewFrustum sight;
  sight.position = {0, 0, 20};
  sight.distance = 20;
  return sight;
}

Viewpoint level_view() {
  return {{0, 0, 20}, {0, 0, 0}, {0, 1, 0}, 0};
}

RealPoint tilted(double degrees_up, double degrees_right) {
  const double up = degrees_up * M_PI / 180, right = degrees_right * M_PI / 180;
  return {std::cos(up) * std::sin(right), std::sin(up), -std::cos(up) * std::cos(right)};
}

TEST(SideAcross, IsNormalToTheLineAndNeverSteep) {
  for (double up = -90; up <= 90; up += 6) {
    for (double right = -180; right <= 180; right += 6) {
      const RealPoint line = tilted(up, right);
      const Vector side = side_across(level_sight(), line);
      EXPECT_NEAR(along(side, side), 1, 1e-9);
      EXPECT_NEAR(along(side, {line.x, line.y, line.z}), 0, 1e-9) << up << " " << right;
      EXPECT_LE(std::fabs(side[1]), 0.9 + 1e-9) << up << " " << right;
    }
  }
}

// Along the line of sight there is no least turn: the view goes to the side, and up stays up.
TEST(SideAcross, OfTheLineOfSightIsLevel) {
  for (const double tilt : {-10.0, -0.1, 0.0, 0.1, 10.0}) {
    const Vector side = side_across(level_sight(), tilted(tilt, 0));
    EXPECT_NEAR(side[1], 0, 1e-9) << tilt;
    EXPECT_NEAR(std::fabs(side[0]), 1, 1e-9) << tilt;
    const Viewpoint view = view_from(level_view(), level_sight(), side);
    EXPECT_EQ(view.up, (Vector{0, 1, 0})) << tilt;
  }
}

TEST(SideAcross, TurnsByTheLeastAngleOtherwise) {
  // A line across the view needs no turn; one 50° off it needs 40°.
  const Vector still = side_across(level_sight(), {1, 0, 0});
  EXPECT_NEAR(still[2], 1, 1e-12);
  const Vector turned = side_across(level_sight(), tilted(0, 50));
  EXPECT_NEAR(turned[2], std::cos(40 * M_PI / 180), 1e-9);
  const Vector lifted = side_across(level_sight(), tilted(50, 0));
  EXPECT_NEAR(lifted[2], std::cos(40 * M_PI / 180), 1e-9);
}

TEST(ViewFrom, KeepsDistanceAndUpwardDirection) {
  const Viewpoint view = view_from(level_view(), level_sight(), {0.6, 0, 0.8});
  EXPECT_NEAR(view.position[0], 12, 1e-12);
  EXPECT_NEAR(view.position[2], 16, 1e-12);
  EXPECT_EQ(view.up, (Vector{0, 1, 0}));
}

// Right stays right, as if the head were bent down or back.
TEST(ViewFrom, AboveAndBelowKeepsTheRightSide) {
  for (const double sign : {1.0, -1.0}) {
    const Vector towards{0.05, sign * std::sqrt(1 - 0.05 * 0.05), 0};  // no axis of the file
    const Viewpoint view = view_from(level_view(), level_sight(), towards);
    const RealPoint forward{-towards[0], -towards[1], -towards[2]};
    const RealPoint right = cross(forward, {view.up[0], view.up[1], view.up[2]});
    EXPECT_GT(right.x, 0.9) << (sign > 0 ? "above" : "below");
  }
}

TEST(ViewOfSide, HasAnUpwardDirectionOfItsOwnAlongAxes) {
  EXPECT_EQ(view_of_side(level_view(), level_sight(), {1, 0, 0}).up, (Vector{0, 0, 1}));
  EXPECT_EQ(view_of_side(level_view(), level_sight(), {0, 0, -1}).up, (Vector{0, 1, 0}));
  EXPECT_EQ(view_of_side(level_view(), level_sight(), {0.6, 0, 0.8}).up, (Vector{0, 1, 0}));
}

}  // namespace
}  // namespace alphascope
