// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the centre line through a wide chamber.
#include "core/channel/centre_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/cavity/rings.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::no_balls;
using testing::Random;
using testing::random_int;

// A wall of balls around a chamber of about this radius (Å), with uneven radii.
BallSet chamber(int radius, unsigned seed) {
  BallSet balls = no_balls();
  Random random(seed);
  const int count = 2 * radius * radius;
  for (int n = 0; n < count; ++n) {
    const double z = (2 * n + 1.0) / count - 1, angle = n * std::numbers::pi * (3 - std::sqrt(5));
    const double around = std::sqrt(1 - z * z), away = 1000 * radius + random_int(random, 0, 6000);
    add_ball(balls, static_cast<int>(away * around * std::cos(angle)),
             static_cast<int>(away * around * std::sin(angle)), static_cast<int>(away * z),
             random_int(random, 2000, 3000));
  }
  return balls;
}

// ∫ dl / clearance² (1/Å)
double narrowness(const std::vector<ChannelSample>& line) {
  double sum = 0;
  for (std::size_t n = 1; n < line.size(); ++n) {
    const double radius = (line[n].radius_angstrom + line[n - 1].radius_angstrom) / 2;
    sum += length(line[n].position_angstrom - line[n - 1].position_angstrom) / (radius * radius);
  }
  return sum;
}

// With the same spacing in the chamber as in narrow parts, the lines are still on their way after
// the last round. The sum for all six is then 7.29 instead of 6.88.
TEST(CentreLine, GetsToTheMiddleOfAWideChamber) {
  double sum = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const BallSet balls = chamber(24, seed);
    const Clearance clearance(balls);
    LineStart start;
    start.curve = {{0, 3, -19}, {0, 19, 3}};
    start.first_fixed = start.last_fixed = true;
    start.end_radius_angstrom = 50;
    const std::vector<ChannelSample> line = centre_line(clearance, Envelope(balls), start, {});
    EXPECT_EQ(line.front().position_angstrom, start.curve.front());
    EXPECT_EQ(line.back().position_angstrom, start.curve.back());
    for (std::size_t n = 1; n < line.size(); ++n) {
      const RealPoint step = line[n].position_angstrom - line[n - 1].position_angstrom;
      EXPECT_LE(length(step), kSpacingAngstrom + 1e-9);
    }
    sum += narrowness(line);
  }
  EXPECT_LT(sum, 7);
}

}  // namespace
}  // namespace alphascope
