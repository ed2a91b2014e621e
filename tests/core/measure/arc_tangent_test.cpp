// SPDX-License-Identifier: GPL-3.0-or-later
// Compares angles with those of more bits.
#include "core/measure/arc_tangent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/measure/ball_geometry.hpp"

namespace alphascope {
namespace {

// Units in the last place between an angle and its value with 64 bits.
double error_of(double y, double x) {
  const long double expected = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  const double found = arc_tangent(y, x);
  const double unit =
      std::nextafter(std::fabs(found), std::numeric_limits<double>::infinity()) - std::fabs(found);
  return static_cast<double>(std::fabs(static_cast<long double>(found) - expected)) / unit;
}

constexpr double kMostUnits = 2;

TEST(ArcTangent, IsWithinTwoUnits) {
  std::mt19937_64 random(101);
  std::uniform_real_distribution<double> one(-1, 1);
  double worst = 0;
  for (int n = 0; n < 300'000; ++n) {
    const double length = std::exp2(30 + 70 * one(random)), steep = std::exp2(60 * one(random));
    worst = std::max(worst, error_of(one(random) * length * steep, one(random) * length));
    worst = std::max(worst, error_of(one(random), one(random)));
  }
  EXPECT_LE(worst, kMostUnits);
}

// Where another eighth is the next one, and where an angle goes on beyond 45 and 90 degrees.
TEST(ArcTangent, IsWithinTwoUnitsAtBounds) {
  double worst = 0;
  for (int sixteenth = -64; sixteenth <= 64; ++sixteenth) {
    double y = sixteenth / 16.0 - 1e-15;
    for (int n = 0; n < 50; ++n, y = std::nextafter(y, 9)) {
      for (const double x : {-1.0, 1.0}) worst = std::max({worst, error_of(y, x), error_of(x, y)});
    }
  }
  EXPECT_LE(worst, kMostUnits);
}

TEST(ArcTangent, KnowsTheAxes) {
  EXPECT_EQ(arc_tangent(0, 0), 0);
  EXPECT_EQ(arc_tangent(0, 3), 0);
  EXPECT_EQ(arc_tangent(3, 0), kPi / 2);
  EXPECT_EQ(arc_tangent(-3, 0), -kPi / 2);
  EXPECT_EQ(arc_tangent(0, -3), kPi);
}

}  // namespace
}  // namespace alphascope
