// SPDX-License-Identifier: GPL-3.0-or-later
// Tests exact decimal numbers and their rounding.
#include "core/read/decimal.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace alphascope {
namespace {

Decimal parsed(std::string_view text) {
  Decimal value{-77, -77};
  EXPECT_EQ(parse_decimal(text, value), DecimalStatus::ok) << text;
  return value;
}

TEST(Decimal, KeepsDigitsAndDropsTrailingZeros) {
  const struct {
    const char* text;
    std::int64_t mantissa;
    int digits;
  } cases[] = {{"1", 1, 0},
               {"-1.50", -15, 1},
               {"+0.001", 1, 3},
               {".5", 5, 1},
               {"5.", 5, 0},
               {"-0.000", 0, 0},
               {"00012.340", 1234, 2},
               {"1e3", 1, -3},
               {"1.25E-2", 125, 4},
               {"2.5D+1", 25, 0},
               {"100", 1, -2},
               {"0e99999999999", 0, 0},
               {"1e300", 1, -300},
               {"999999999999999999", 999999999999999999, 0}};
  for (const auto& c : cases) {
    const Decimal value = parsed(c.text);
    EXPECT_EQ(value.mantissa, c.mantissa) << c.text;
    EXPECT_EQ(value.digits, c.digits) << c.text;
  }
}

TEST(Decimal, RefusesWhatIsNoNumber) {
  Decimal value;
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", "0x10", "1 2", "12a"}) {
    EXPECT_EQ(parse_decimal(text, value), DecimalStatus::malformed) << text;
  }
  for (const char* text : {"nan", "NaN", "-inf", "Infinity", "+INF", "1.#QNAN"}) {
    EXPECT_EQ(parse_decimal(text, value), DecimalStatus::not_finite) << text;
  }
}

TEST(Decimal, ConvertsToUnitsExactlyOrRoundsOnce) {
  double rounding;
  EXPECT_EQ(to_units(parsed("-12.345"), 3, rounding), -12345);
  EXPECT_EQ(rounding, 0);
  EXPECT_EQ(to_units(parsed("-12.345"), 5, rounding), -1234500);
  EXPECT_EQ(rounding, 0);
  EXPECT_EQ(to_units(parsed("-12.345"), 2, rounding), -1235);  // half away from zero
  EXPECT_DOUBLE_EQ(rounding, 0.5);
  EXPECT_EQ(to_units(parsed("12.3449"), 2, rounding), 1234);
  EXPECT_EQ(to_units(parsed("4e-30"), 3, rounding), 0);
  EXPECT_GT(rounding, 0);
  EXPECT_EQ(to_units(parsed("1e300"), 3, rounding), std::int64_t{1} << 62);
  EXPECT_EQ(to_units(parsed("-1e300"), 3, rounding), -(std::int64_t{1} << 62));
}

TEST(Decimal, BecomesTheNearestDouble) {
  for (const char* text :
       {"12.345", "-0.1", "1e22", "123456789.123456", "1e-18", "0.3", "2.5e-7"}) {
    EXPECT_EQ(parsed(text).to_double(), std::strtod(text, nullptr)) << text;
  }
  EXPECT_NEAR(parsed("1e-30").to_double(), 1e-30, 1e-45);
}

TEST(Decimal, CutDigitsStillDecideATie) {
  // 30 digits: just above, at and just below 0.5 units.
  double rounding;
  EXPECT_EQ(to_units(parsed("1.0005000000000000000000000001"), 3, rounding), 1001);
  EXPECT_EQ(to_units(parsed("1.0005000000000000000000000000"), 3, rounding), 1001);
  EXPECT_EQ(to_units(parsed("1.0004999999999999999999999999"), 3, rounding), 1000);
  EXPECT_EQ(to_units(parsed("123456789012345678901234567890e-27"), 3, rounding), 123457);
}

}  // namespace
}  // namespace alphascope
