// SPDX-License-Identifier: GPL-3.0-or-later
// Tests clearance, and functions built on it alone, against the definition.
#include "core/clearance/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/clearance/equal_clearance.hpp"
#include "core/clearance/plane_ascent.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::Random;
using testing::random_int;

double distance_to(const BallSet& balls, BallIndex i, const RealPoint& x) {
  const double unit = balls.lattice.unit_angstrom();
  return length(x - unit * real_point(balls.centres[i])) - unit * balls.radii[i];
}

// Radii from 0.05 to 40 Å need several grids.
BallSet unequal_balls(Random& random, int count) {
  BallSet balls;
  balls.lattice.digits = 3;
  const int sizes[] = {50, 300, 1200, 1900, 8000, 40000};
  for (int n = 0; n < count; ++n) {
    const int size = sizes[random_int(random, 0, random_int(random, 0, 5))];
    add_ball(balls, random_int(random, -30000, 30000), random_int(random, -30000, 30000),
             random_int(random, -9000, 9000), random_int(random, size / 2 + 1, size));
  }
  return balls;
}

// Balls with one centre are a single entry with their largest radius. Otherwise a point near a
// million of them would visit each.
TEST(Clearance, OfBallsWithOneCentreTheLargestCounts) {
  BallSet balls;
  balls.lattice.digits = 3;
  for (const int radius : {1000, 1500, 1200, 1500}) add_ball(balls, 0, 0, 0, radius);
  add_ball(balls, 4000, 0, 0, 1000);
  const Clearance clearance(balls);
  std::vector<Surface> surfaces;
  clearance.collect({2, 0, 0}, 10, surfaces);
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].ball, 1u);
  EXPECT_EQ(surfaces[0].distance_angstrom, 0.5);
  EXPECT_EQ(surfaces[1].ball, 4u);
}

TEST(Clearance, IsTheLeastDistanceToASurface) {
  Random random(1);
  for (const int count : {1, 2, 7, 60, 900}) {
    const BallSet balls = unequal_balls(random, count);
    const Clearance clearance(balls);
    std::vector<Surface> surfaces;
    for (int n = 0; n < 200; ++n) {
      const int reach = n % 10 == 0 ? 2000000 : 45000;  // some far outside
      const RealPoint x{random_int(random, -reach, reach) / 1000.0,
                        random_int(random, -reach, reach) / 1000.0,
                        random_int(random, -reach, reach) / 1000.0};
      BallIndex nearest = 0;
      for (BallIndex i = 1; i < balls.size(); ++i) {
        if (distance_to(balls, i, x) < distance_to(balls, nearest, x)) nearest = i;
      }
      const Surface found = clearance.nearest(x);
      const double expected = distance_to(balls, nearest, x);
      EXPECT_NEAR(found.distance_angstrom, expected, 1e-9);
      EXPECT_NEAR(distance_to(balls, found.ball, x), expected, 1e-9);
      EXPECT_NEAR(length(found.away), 1, 1e-12);

      clearance.collect(x, expected + 1.5, surfaces);
      std::size_t within = 0;
      for (BallIndex i = 0; i < balls.size(); ++i) {
        within += distance_to(balls, i, x) <= expected + 1.5;
      }
      ASSERT_EQ(surfaces.size(), within);
      EXPECT_EQ(surfaces[0].ball, found.ball);
      for (std::size_t k = 1; k < surfaces.size(); ++k) {
        EXPECT_LE(surfaces[k - 1].distance_angstrom, surfaces[k].distance_angstrom);
      }
    }
  }
}

TEST(Clearance, OfEqualSurfacesTheLowestIndexIsNearest) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const int x : {6, -6}) add_ball(balls, x, 0, 0, 2);
  add_ball(balls, 0, 6, 0, 2);
  const Surface found = Clearance(balls).nearest({0, 0, 0});
  EXPECT_EQ(found.ball, 0u);
  EXPECT_DOUBLE_EQ(found.distance_angstrom, 4);
}

TEST(EqualClearance, IsTheSameForAllThree) {
  Random random(2);
  int found = 0;
  for (int n = 0; n < 300; ++n) {
    const BallSet balls = testing::random_balls(random, 3, 20, 1, 8);
    const EqualClearance place = equal_clearance(balls, {0, 1, 2});
    if (!place.found) continue;
    ++found;
    for (BallIndex i = 0; i < 3; ++i) {
      EXPECT_NEAR(distance_to(balls, i, place.place_angstrom), place.clearance_angstrom, 1e-6);
    }
  }
  EXPECT_GT(found, 200);
}

TEST(EqualClearance, InAPlaneIsThatOfTwo) {
  BallSet balls;
  balls.lattice.digits = 0;
  add_ball(balls, -10, 0, 3, 4);
  add_ball(balls, 12, 5, -2, 6);
  const EqualClearance place = equal_clearance_in_plane(balls, {0, 1}, {{0, 0, 1}, {0, 0, 1}});
  ASSERT_TRUE(place.found);
  EXPECT_NEAR(place.place_angstrom.z, 1, 1e-12);
  for (BallIndex i = 0; i < 2; ++i) {
    EXPECT_NEAR(distance_to(balls, i, place.place_angstrom), place.clearance_angstrom, 1e-9);
  }
}

TEST(EqualClearance, OfBallsOnOneLineIsNot) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const int x : {0, 5, 11}) add_ball(balls, x, x, 2 * x, 1);
  EXPECT_FALSE(equal_clearance(balls, {0, 1, 2}).found);
}

// Between three balls of any radii the place is known in closed form.
TEST(PlaneAscent, SettlesBetweenThreeBalls) {
  BallSet balls;
  balls.lattice.digits = 3;
  add_ball(balls, 5000, 0, 0, 1500);
  add_ball(balls, -2500, 4600, 0, 1100);
  add_ball(balls, -2400, -4500, 0, 2000);
  const EqualClearance expected = equal_clearance(balls, {0, 1, 2});
  const Clearance clearance(balls);
  for (const RealPoint& start :
       {RealPoint{0.4, 0.7, 0}, RealPoint{1.5, -1.0, 0}, RealPoint{-1.2, 2.0, 0}}) {
    const Ascent ascent = ascend_in_plane(clearance, start, {0, 0, 1}, {0.2, 1e-7, 100, 100});
    EXPECT_TRUE(ascent.settled);
    EXPECT_LT(length(ascent.place - expected.place_angstrom), 1e-6);
  }
}

// A ring of 3 to 90 balls, all of which touch at once. The start is outside its plane.
TEST(PlaneAscent, SettlesOnTheAxisOfARing) {
  for (const int count : {3, 4, 5, 6, 12, 90}) {
    BallSet balls;
    balls.lattice.digits = 6;
    for (int n = 0; n < count; ++n) {
      const double angle = 6.283185307179586 * n / count;
      add_ball(balls, static_cast<int>(std::lround(6e6 * std::cos(angle))),
               static_cast<int>(std::lround(6e6 * std::sin(angle))), 0, 2000000);
    }
    const Ascent ascent =
        ascend_in_plane(Clearance(balls), {0.8, -1.1, 0.5}, {0, 0, 1}, {0.2, 1e-7, 100, 100});
    EXPECT_TRUE(ascent.settled) << count;
    EXPECT_LT(std::hypot(ascent.place.x, ascent.place.y), 1e-4) << count;
    EXPECT_EQ(ascent.place.z, 0.5);
  }
}

TEST(PlaneAscent, EndsWhereThePlaneIsOpen) {
  BallSet balls;
  balls.lattice.digits = 0;
  add_ball(balls, 0, 0, 0, 2);
  add_ball(balls, 9, 0, 0, 2);
  const Ascent ascent =
      ascend_in_plane(Clearance(balls), {4, 1, 0}, {0, 0, 1}, {0.2, 1e-7, 50, 1e9});
  EXPECT_FALSE(ascent.settled);
  EXPECT_GE(Clearance(balls).at(ascent.place), 50);
}

}  // namespace
}  // namespace alphascope
