// SPDX-License-Identifier: GPL-3.0-or-later
// Tests round numbers on axes.
#include "core/chart/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace alphascope {
namespace {

TEST(Ticks, StepsAreOneTwoOrFiveAndCoverTheSpan) {
  EXPECT_DOUBLE_EQ(nice_step(10, 5), 2);
  EXPECT_DOUBLE_EQ(nice_step(10, 4), 5);
  EXPECT_DOUBLE_EQ(nice_step(10, 1), 10);
  EXPECT_DOUBLE_EQ(nice_step(0.03, 3), 0.01);
  EXPECT_DOUBLE_EQ(nice_step(7, 0), 10) << "at least one";
  int tried = 0;
  for (double span = 1e-5; span < 1e7; span *= 1.7) {
    for (int most = 1; most < 30; ++most) {
      const double step = nice_step(span, most);
      EXPECT_GE(step * most, span * (1 - 1e-8));
      EXPECT_LE(step, 2.5 * span / most * (1 + 1e-8)) << "not far more than needed";
      const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
      EXPECT_TRUE(std::fabs(digit - 1) < 1e-6 || std::fabs(digit - 2) < 1e-6 ||
                  std::fabs(digit - 5) < 1e-6)
          << step;
      ++tried;
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST(Ticks, RoundValuesAreMultiplesWithinTheRange) {
  EXPECT_EQ(round_values(-0.5, 2.1, 1), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(round_values(0.1, 0.3, 0.1).size(), 3u) << "ends count";
  EXPECT_TRUE(round_values(0.1, 0.9, 1).empty());
  EXPECT_TRUE(round_values(0, 1e9, 1).empty()) << "more than anybody reads";
}

TEST(Ticks, TextsHaveTheDecimalsOfTheStep) {
  EXPECT_EQ(tick_text(0.5, 0.1), "0.5");
  EXPECT_EQ(tick_text(0.5, 0.05), "0.50");
  EXPECT_EQ(tick_text(3, 1), "3");
  EXPECT_EQ(tick_text(-2, 2), "−2");
  EXPECT_EQ(tick_text(12500, 500), "12,500");
  EXPECT_EQ(tick_text(0.3, 0.1), "0.3") << "of 3 * 0.1";
  EXPECT_EQ(tick_text(2e12, 1e12), "2·10¹²");
}

}  // namespace
}  // namespace alphascope
