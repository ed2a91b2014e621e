// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the record of how a decision was made: by a filter, by integers, or by the perturbation.
#include "core/explain/recorded_steps.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/explain/nearest_by_power.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

bool has(const std::vector<ArithmeticStep>& steps, Arithmetic by) {
  for (const ArithmeticStep& step : steps) {
    if (step.by == by) return true;
  }
  return false;
}

// d² + r² of the first - r² of the other is 1 or -1, among squares of 2.5e15, so no filter can
// decide.
TEST(RecordedSteps, OfAVertexIntegersDecideWhatFiltersCannot) {
  for (const int sign : {1, -1}) {
    BallSet balls;
    const std::int32_t d = sign > 0 ? 49'999'999 : 50'000'000;
    testing::add_ball(balls, 0, 0, 0, 10'000);
    testing::add_ball(balls, d, 0, 0, d + 1);
    const std::array<BallIndex, 1> vertex{0};
    const auto steps = steps_of_margin(balls, vertex, 1);
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps.back().by, Arithmetic::integers);
    EXPECT_EQ(steps.back().sign, sign);
  }
}

// A filter is used only when all vectors are within its range.
TEST(RecordedSteps, AFilterIsNotAskedBeyondItsRange) {
  for (const std::int32_t far : {1'000, 20'000'000, 100'000'000}) {
    BallSet balls;
    testing::add_ball(balls, 0, 0, 0, 500);
    testing::add_ball(balls, far, 0, 0, 500);
    testing::add_ball(balls, 0, 700, 0, 500);
    const std::array<BallIndex, 2> edge{0, 1};
    const auto steps = steps_of_margin(balls, edge, 2);
    SCOPED_TRACE(far);
    EXPECT_EQ(has(steps, Arithmetic::single_filter), far == 1'000);
    EXPECT_EQ(has(steps, Arithmetic::integers), far == 100'000'000) << "beyond both";
    EXPECT_EQ(steps.back().sign, 1);
  }
}

// Balls of radius 1 at x = 0, 10, … 40, and a query point at 17.
TEST(NearestByPower, AreThoseOfLeastPowerFirst) {
  BallSet balls;
  for (int n = 0; n < 5; ++n) testing::add_ball(balls, 10 * n, 0, 0, 1);
  const std::array<PointAtBall, 2> points{{{0, {17, 0, 0}}, {4, {-9, 0, 0}}}};
  const auto near = nearest_by_power(balls, points, {}, 3);
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0], (std::vector<BallIndex>{2, 1, 3}));
  EXPECT_EQ(near[1], (std::vector<BallIndex>{3, 4, 2})) << "31 from ball 4";
  const std::array<BallIndex, 1> without{2};
  EXPECT_EQ(nearest_by_power(balls, {points.data(), 1}, without, 2)[0],
            (std::vector<BallIndex>{1, 3}));
  balls.radii[0] = 17;  // 289 - 289 is less than 9 - 1
  EXPECT_EQ(nearest_by_power(balls, {points.data(), 1}, {}, 1)[0], (std::vector<BallIndex>{0}));
}

}  // namespace
}  // namespace alphascope
