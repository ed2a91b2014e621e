// SPDX-License-Identifier: GPL-3.0-or-later
// Tests ascents in planes among random balls.
#include "core/clearance/plane_ascent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/core/cavity/rings.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::no_balls;
using testing::Random;
using testing::random_int;

RealPoint random_point(Random& random, int size) {
  const auto next = [&] { return random_int(random, -size, size) / 1000.0; };
  return {next(), next(), next()};
}

// An ascent whose steps must not get shorter ends where the best one gains less than a thousandth
// of its length. In a crowd many surfaces are within its reach, and few of them limit it.
TEST(PlaneAscent, TakesTheBestStepInACrowd) {
  constexpr double kStep = 0.02, kAnywhere = std::numeric_limits<double>::infinity();
  Random random(11);
  for (int set = 0; set < 200; ++set) {
    // All of about the same distance from the origin.
    BallSet balls = no_balls();
    for (int n = 0; n < 14; ++n) {
      const RealPoint p = 8000 * unit_vector(random_point(random, 1000));
      add_ball(balls, static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z),
               random_int(random, 2990, 3010));
    }
    const Clearance clearance(balls);
    const RealPoint start = random_point(random, 30);
    const RealPoint normal = unit_vector(random_point(random, 1000));
    const Ascent ascent = ascend_in_plane(clearance, start, normal, {kStep, kStep, 20, kAnywhere});
    EXPECT_TRUE(ascent.settled);
    EXPECT_NEAR(dot(ascent.place - start, normal), 0, 1e-9);
    EXPECT_NEAR(ascent.clearance_angstrom, clearance.at(ascent.place), 1e-9);
    EXPECT_GE(ascent.clearance_angstrom, clearance.at(start));
    RealPoint first, second;
    normals_of(normal, first, second);
    double most = 0;
    for (int x = -20; x <= 20; ++x) {
      for (int y = -20; y <= 20; ++y) {
        if (x * x + y * y > 400) continue;
        const RealPoint aside = kStep / 20 * (x * first + y * second);
        most = std::max(most, clearance.at(ascent.place + aside));
      }
    }
    // Steps are found for flat surfaces. These are curved.
    EXPECT_LE(most, ascent.clearance_angstrom + 1e-3 * kStep + kStep * kStep / 8);
  }
}

// Between two balls alone, clearance rises without end.
TEST(PlaneAscent, StopsAtItsLimits) {
  BallSet balls = no_balls();
  for (const int x : {-4000, 4000}) add_ball(balls, x, 0, 0, 1000);
  const Clearance clearance(balls);
  const RealPoint start{0, 0.1, 0}, normal{0, 0, 1};
  const Ascent near = ascend_in_plane(clearance, start, normal, {0.5, 1e-7, 100, 2});
  EXPECT_FALSE(near.settled);
  EXPECT_NEAR(near.place.x, 0, 1e-3);
  EXPECT_GE(near.place.y, 2);
  EXPECT_LT(near.place.y, 2.7);
  const Ascent wide = ascend_in_plane(clearance, start, normal, {0.5, 1e-7, 5, 100});
  EXPECT_FALSE(wide.settled);
  EXPECT_GE(wide.clearance_angstrom, 5);
  EXPECT_LT(wide.clearance_angstrom, 5.5);
}

}  // namespace
}  // namespace alphascope
