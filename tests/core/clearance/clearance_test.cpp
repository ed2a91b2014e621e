// SPDX-License-Identifier: GPL-3.0-or-later
// Tests clearance, and functions built on it alone, against the definition.
#include "core/clearance/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

// The surfaces of all balls that no other ball with the same centre covers, sorted as collect()
// sorts them.
std::vector<Surface> all_surfaces(const BallSet& balls, const RealPoint& x_angstrom) {
  const double unit = balls.lattice.unit_angstrom();
  const RealPoint x = (1 / unit) * x_angstrom;
  std::vector<Surface> surfaces;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    bool is_covered = false;
    for (BallIndex k = 0; k < balls.size(); ++k) {
      if (k == i || balls.centres[k] != balls.centres[i]) continue;
      is_covered |= balls.radii[k] > balls.radii[i] || (balls.radii[k] == balls.radii[i] && k < i);
    }
    if (is_covered) continue;
    const RealPoint away = x - real_point(balls.centres[i]);
    surfaces.push_back({unit * (length(away) - balls.radii[i]), i, unit_vector(away)});
  }
  std::sort(surfaces.begin(), surfaces.end(), [](const Surface& a, const Surface& b) {
    return a.distance_angstrom != b.distance_angstrom ? a.distance_angstrom < b.distance_angstrom
                                                      : a.ball < b.ball;
  });
  return surfaces;
}

void expect_equal(const std::vector<Surface>& found, const std::vector<Surface>& expected,
                  std::size_t count) {
  ASSERT_EQ(found.size(), count);
  for (std::size_t n = 0; n < count; ++n) {
    EXPECT_EQ(found[n].ball, expected[n].ball) << n;
    EXPECT_EQ(found[n].distance_angstrom, expected[n].distance_angstrom) << n;
    EXPECT_EQ(found[n].away, expected[n].away) << n;
  }
}

struct SomeBalls {
  std::string name;
  BallSet balls;
  int extent;  // lattice units
};

// Scattered, clustered, coincident, collinear, distant and unequal balls.
std::vector<SomeBalls> various_balls(Random& random) {
  std::vector<SomeBalls> sets;
  for (const int count : {1, 8, 9, 17, 300}) {
    sets.push_back({"scattered", testing::random_balls(random, count, 30, 1, 6), 30});
  }
  sets.push_back({"dense", testing::random_balls(random, 400, 4, 1, 3), 4});
  SomeBalls clusters{"clusters", {}, 100000}, line{"line", {}, 500}, far{"far", {}, 500000000};
  for (int n = 0; n < 200; ++n) {
    const int at = 90000 * (n % 3 - 1);
    add_ball(clusters.balls, at + random_int(random, -9, 9), at + random_int(random, -9, 9),
             -at + random_int(random, -9, 9), random_int(random, 1, 5));
    add_ball(line.balls, random_int(random, -500, 500), 7, 7, random_int(random, 1, 40));
    add_ball(far.balls, random_int(random, -500000000, 500000000), random_int(random, 0, 1),
             random_int(random, -500000000, 500000000), random_int(random, 1, 400000000));
  }
  for (SomeBalls* set : {&clusters, &line, &far}) sets.push_back(*set);
  sets.push_back({"unequal", unequal_balls(random, 300), 45000});
  return sets;
}

// Coordinates are whole numbers, so many distances are equal.
RealPoint random_place(Random& random, const SomeBalls& set, int n) {
  const int extent = n % 5 == 0 ? 900000000 : n % 5 == 1 ? set.extent / 8 + 1 : set.extent;
  const double unit = set.balls.lattice.unit_angstrom();
  return unit * RealPoint{static_cast<double>(random_int(random, -extent, extent)),
                          static_cast<double>(random_int(random, -extent, extent)),
                          static_cast<double>(random_int(random, -extent, extent))};
}

TEST(Clearance, TheTreeFindsExactlyWhatAllBallsGive) {
  Random random(11);
  for (const SomeBalls& set : various_balls(random)) {
    SCOPED_TRACE(set.name + ", " + std::to_string(set.balls.size()));
    const Clearance clearance(set.balls);
    const double unit = set.balls.lattice.unit_angstrom();
    std::vector<Surface> found;
    for (int n = 0; n < 30; ++n) {
      RealPoint x = random_place(random, set, n);
      if (n % 7 == 0) x = unit * real_point(set.balls.centres[n % set.balls.size()]);
      const std::vector<Surface> expected = all_surfaces(set.balls, x);
      const Surface nearest = clearance.nearest(x);
      EXPECT_EQ(nearest.ball, expected[0].ball);
      EXPECT_EQ(nearest.distance_angstrom, expected[0].distance_angstrom);
      EXPECT_EQ(nearest.away, expected[0].away);
      // Up to the surface itself, just not to it, and to all.
      for (const std::size_t last : {std::size_t{0}, expected.size() / 3, expected.size() - 1}) {
        const double most = expected[last].distance_angstrom;
        for (const double limit : {most, std::nextafter(most, -1e300)}) {
          const auto is_within = [&](const Surface& s) {
            const RealPoint away = (1 / unit) * x - real_point(set.balls.centres[s.ball]);
            return length(away) - set.balls.radii[s.ball] <= limit / unit;
          };
          const auto count =
              static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), is_within));
          clearance.collect(x, limit, found);
          expect_equal(found, expected, count);
        }
      }
    }
  }
}

TEST(Clearance, NearbyBallsGiveTheSame) {
  constexpr double kAround = 0.7;
  Random random(12);
  for (const SomeBalls& set : various_balls(random)) {
    if (set.name == "far") continue;
    SCOPED_TRACE(set.name + ", " + std::to_string(set.balls.size()));
    const Clearance clearance(set.balls);
    ClearanceNearby nearby(clearance);
    std::vector<Surface> found, expected;
    RealPoint x;
    for (int n = 0; n < 120; ++n) {
      const auto step = [&](double size) { return size * random_int(random, -100, 100) / 100.0; };
      x = n % 50 == 0 ? random_place(random, set, n / 50)
                      : x + RealPoint{step(0.2), step(0.2), step(0.2)};
      const double own = nearby.look_around(x, kAround);
      ASSERT_EQ(own, clearance.at(x));
      // What is nearest here is at most half as far as the balls around decide.
      const RealPoint beside =
          x + (0.999 * kAround / 2) * unit_vector({step(1), step(1), step(1) + 0.001});
      ASSERT_EQ(nearby.at(beside), clearance.at(beside));
      for (const std::size_t most : {std::size_t{3}, set.balls.size()}) {
        nearby.collect(x, own + kAround, most, found);
        clearance.collect(x, own + kAround, expected);
        expect_equal(found, expected, std::min(most, expected.size()));
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
