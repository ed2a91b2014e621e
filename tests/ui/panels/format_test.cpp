// SPDX-License-Identifier: GPL-3.0-or-later
// Tests numbers as panels print them.
#include "ui/widgets/format.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/document/settings/request.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/point_text.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/text/fixed_digits.hpp"
#include "core/text/short_number.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/ball_text.hpp"

namespace alphascope {
namespace {

TEST(Format, CountsHaveSeparators) {
  EXPECT_EQ(with_separators(0), "0");
  EXPECT_EQ(with_separators(999), "999");
  EXPECT_EQ(with_separators(1000), "1,000");
  EXPECT_EQ(with_separators(58674), "58,674");
  EXPECT_EQ(with_separators(16284240), "16,284,240");
  EXPECT_EQ(with_separators(-837), "−837");
  EXPECT_EQ(with_separators(-1234567), "−1,234,567");
}

TEST(Format, SentencesHaveTrueMinusSigns) {
  EXPECT_EQ(with_minus_signs("-1 Å² at (-2.5, -3, 4-5) with A:GLY-3, e-5 and a-b - c"),
            "−1 Å² at (−2.5, −3, 4-5) with A:GLY-3, e-5 and a-b - c");
}

TEST(Format, TimesHaveThreeDigitsAndAUnit) {
  EXPECT_EQ(milliseconds_text(0.0421), "0.042 ms");
  EXPECT_EQ(milliseconds_text(2.534), "2.53 ms");
  EXPECT_EQ(milliseconds_text(0.0006), "0.001 ms");
  EXPECT_EQ(milliseconds_text(0.0002), "<0.001 ms");  // it ran, so it took some time
  EXPECT_EQ(milliseconds_text(0), "0 ms");
  EXPECT_EQ(milliseconds_text(52.83), "52.8 ms");
  EXPECT_EQ(milliseconds_text(159.9), "160 ms");
  EXPECT_EQ(milliseconds_text(1240), "1.24 s");
}

TEST(Format, NumbersAreAsShortAsTheirValue) {
  EXPECT_EQ(short_number_text(1.4, 3), "1.4");
  EXPECT_EQ(short_number_text(10, 3), "10");
  EXPECT_EQ(short_number_text(-0.25, 3), "−0.25");
  EXPECT_EQ(number_text(-0.04, 1), "0.0") << "no zero has a sign";
  EXPECT_EQ(number_text(-0.05, 2), "−0.05");
  EXPECT_EQ(short_number_text(-0.0004, 3), "0");
  EXPECT_EQ(short_number_text(-0.0001, 3), "0");
  EXPECT_EQ(short_number_text(100, 0), "100");
}

TEST(Format, ZeroHasNoMinusSign) {
  EXPECT_EQ(shortest_number(-0.0), "0");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(number_text(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_digits(-0.0, 3), "0.000");
  EXPECT_EQ(fixed_digits(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_digits(-0.00051, 3), "-0.001");
  EXPECT_EQ(fixed_digits(-1e300, 0).size(), 302u);
  EXPECT_EQ(point_text({-0.0001, 2.5, -3}), "0.000, 2.500, -3.000");
}

// √(1.7² + 1.4) = 2.0712. Both numbers have two digits, or three if the radius has more than two.
TEST(Format, ARadiusAndTheGrownOneHaveTheSameDigits) {
  BallSet balls;
  balls.lattice.digits = 3;
  balls.centres.push_back({0, 0, 0});
  balls.radii.push_back(1700);
  Request shown;
  shown.alpha_angstrom2 = 0;
  EXPECT_EQ(radius_text(balls, &shown, 0), "radius 1.70 Å, grown 1.70 Å");
  shown.alpha_angstrom2 = 1.4;
  EXPECT_EQ(radius_text(balls, &shown, 0), "radius 1.70 Å, grown 2.07 Å");
  EXPECT_EQ(radius_text(balls, nullptr, 0), "radius 1.70 Å");
}

TEST(Format, RatiosAndBytes) {
  EXPECT_EQ(ratio_text(3.21), "3.2×");
  EXPECT_EQ(ratio_text(412), "412×");
  EXPECT_EQ(ratio_text(5568.4), "5,568×");
  EXPECT_EQ(ratio_text(0.824), "0.82×");
  EXPECT_EQ(ratio_text(0.02), "0.02×");
  EXPECT_EQ(ratio_text(0.0049), "< 0.01×");
  EXPECT_EQ(ratio_text(std::numeric_limits<double>::infinity()), "–");
  EXPECT_EQ(bytes_text(340'000'000), "340 MB");
  EXPECT_EQ(bytes_text(2'470'000'000), "2.47 GB");
}

}  // namespace
}  // namespace alphascope
