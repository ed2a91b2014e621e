// SPDX-License-Identifier: GPL-3.0-or-later
// Tests borders between cells: both balls have equal power there, and no ball has less.
#include "core/explain/power_diagram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/five_balls.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;

double power(const BallSet& balls, BallIndex i, const RealPoint& x) {
  const RealPoint d = x - balls.lattice.unit_angstrom() * real_point(balls.centres[i]);
  const double r = balls.lattice.angstrom(balls.radii[i]);
  return dot(d, d) - r * r;
}

BallSet no_balls() {
  BallSet balls;
  balls.lattice.digits = 0;
  return balls;
}

// The plane between balls of radii 2 and 1 that are 5 apart: 10 x = 25 + 4 - 1.
TEST(PowerDiagram, OfTwoBallsIsAPlane) {
  BallSet balls = no_balls();
  add_ball(balls, 0, 0, 0, 2);
  add_ball(balls, 5, 0, 0, 1);
  const std::vector<PowerFace> faces = power_diagram(balls);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].a, 0u);
  EXPECT_EQ(faces[0].b, 1u);
  ASSERT_EQ(faces[0].corners_angstrom.size(), 4u);
  for (const RealPoint& corner : faces[0].corners_angstrom) {
    EXPECT_NEAR(corner.x, 2.8, 1e-12);
    EXPECT_GT(std::fabs(corner.y), 2) << "beyond the balls";
    EXPECT_GT(std::fabs(corner.z), 2);
  }
}

// A ball in the middle of four others at (±2, ±2, ±2), all of equal radius. Its cell is a
// tetrahedron with corners at (±a, ±a, ±a), where 3 a 2 = 3 · 2².
TEST(PowerDiagram, TheCellOfTheMiddleBallIsATetrahedron) {
  BallSet balls = no_balls();
  add_ball(balls, 0, 0, 0, 2);
  for (const auto& [x, y, z] : {std::array{2, 2, 2}, {2, -2, -2}, {-2, 2, -2}, {-2, -2, 2}}) {
    add_ball(balls, x, y, z, 2);
  }
  std::size_t around = 0;
  std::set<std::array<long, 3>> corners;
  for (const PowerFace& face : power_diagram(balls)) {
    if (face.a != 0) continue;
    ++around;
    EXPECT_EQ(face.corners_angstrom.size(), 3u);
    for (const RealPoint& c : face.corners_angstrom) {
      for (const double x : {c.x, c.y, c.z}) EXPECT_NEAR(std::fabs(x), 3, 1e-9);
      corners.insert({std::lround(c.x), std::lround(c.y), std::lround(c.z)});
    }
  }
  EXPECT_EQ(around, 4u);
  EXPECT_EQ(corners,
            (std::set<std::array<long, 3>>{{-3, -3, -3}, {-3, 3, 3}, {3, -3, 3}, {3, 3, -3}}));
}

TEST(PowerDiagram, HiddenAndEqualBallsHaveNoBorder) {
  BallSet balls = no_balls();
  add_ball(balls, 0, 0, 0, 3);
  add_ball(balls, 0, 0, 0, 3);  // equal to the first
  add_ball(balls, 0, 0, 0, 2);  // within it
  add_ball(balls, 10, 0, 0, 3);
  const std::vector<PowerFace> faces = power_diagram(balls);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].a, 0u);
  EXPECT_EQ(faces[0].b, 3u);
}

TEST(PowerDiagram, ManyBallsAreNotDrawn) {
  BallSet balls = no_balls();
  for (int i = 0; i < static_cast<int>(kMostBallsOfDiagram); ++i) add_ball(balls, 5 * i, 0, 0, 1);
  EXPECT_EQ(power_diagram(balls).size(), kMostBallsOfDiagram - 1);
  add_ball(balls, -5, 0, 0, 1);
  EXPECT_TRUE(power_diagram(balls).empty());
  EXPECT_TRUE(power_diagram(no_balls()).empty());
}

TEST(PowerDiagram, NoBallHasLessPowerOnABorder) {
  testing::Random random(7);
  std::size_t corners = 0;
  for (int n = 0; n < 30; ++n) {
    const BallSet balls = testing::random_balls(random, 30, 20, 2, 9);
    for (const PowerFace& face : power_diagram(balls)) {
      for (const RealPoint& x : face.corners_angstrom) {
        const double least = power(balls, face.a, x);
        EXPECT_NEAR(power(balls, face.b, x), least, 1e-8);
        for (BallIndex k = 0; k < balls.size(); ++k) EXPECT_GE(power(balls, k, x), least - 1e-8);
        ++corners;
      }
    }
  }
  EXPECT_GT(corners, 5000u);
}

}  // namespace
}  // namespace alphascope
