// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alpha as a decimal, and in square lattice units.
#include "core/geometry/alpha.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::random_int;

Alpha alpha_of(const std::string& text) {
  Alpha alpha;
  EXPECT_EQ(Alpha::read(text, alpha), Alpha::Reading::ok) << text;
  return alpha;
}
Alpha::Reading reading_of(const std::string& text) {
  Alpha alpha;
  return Alpha::read(text, alpha);
}

TEST(Alpha, KeepsEveryDigitThatIsTyped) {
  EXPECT_EQ(alpha_of("1.000000000000000001").digits(), "1.000000000000000001");
  EXPECT_EQ(alpha_of("-0.000000000000000001").digits(), "-0.000000000000000001");
  EXPECT_EQ(alpha_of("-1.5").digits(), "-1.5");
  EXPECT_EQ(alpha_of("+2.50000000000000000000000").digits(), "2.5");
  EXPECT_EQ(alpha_of("1.5e3").digits(), "1500");
  EXPECT_EQ(alpha_of("-15e-4").digits(), "-0.0015");
  EXPECT_EQ(alpha_of("999999999999999999999999.999999999999999999").digits(),
            "999999999999999999999999.999999999999999999");
  EXPECT_EQ(alpha_of("-0").digits(), "0");
  EXPECT_LT(alpha_of("0.1"), alpha_of("0.100000000000000001"));
  EXPECT_LT(alpha_of("-0.100000000000000001"), alpha_of("-0.1"));
}

TEST(Alpha, IsOfADoubleTheDecimalThatIsShown) {
  EXPECT_EQ(Alpha(0.1), alpha_of("0.1"));
  EXPECT_EQ(Alpha(1.4), alpha_of("1.4"));
  EXPECT_EQ(Alpha(-0.74949975), alpha_of("-0.74949975"));
  EXPECT_EQ(Alpha(1e24), alpha_of("1e24"));
  EXPECT_EQ(Alpha(1e-20), alpha_of("0"));  // to 18 digits
  EXPECT_EQ(Alpha(6e-19), alpha_of("0.000000000000000001"));
  EXPECT_TRUE(alpha_of("0.1").is_shortest_of_double());
  EXPECT_FALSE(alpha_of("0.100000000000000001").is_shortest_of_double());
  EXPECT_FALSE(Alpha(HUGE_VAL).is_decimal());
  EXPECT_LT(Alpha(1e24), Alpha(HUGE_VAL));
  EXPECT_FALSE(Alpha(std::nan("")) == Alpha(std::nan("")));
}

TEST(Alpha, RefusesWhatItCannotKeep) {
  EXPECT_EQ(reading_of("0.1000000000000000001"), Alpha::Reading::too_fine);
  EXPECT_EQ(reading_of("1e-19"), Alpha::Reading::too_fine);
  EXPECT_EQ(reading_of("1e-999999999999"), Alpha::Reading::too_fine);
  EXPECT_EQ(reading_of("1000000000000000000000000.000000000000000001"), Alpha::Reading::too_large);
  EXPECT_EQ(reading_of("-1.1e24"), Alpha::Reading::too_large);
  EXPECT_EQ(reading_of("1e999999999999"), Alpha::Reading::too_large);
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", "nan", "inf", "0x1", " 1"}) {
    EXPECT_EQ(reading_of(text), Alpha::Reading::malformed) << text;
  }
}

mpq_class rational(const LatticeAlpha& alpha) {
  if (alpha.is_double()) return mpq_class(alpha.below);
  std::string text = alpha.text();
  const std::size_t point = text.find('.');
  const std::size_t places = point == std::string::npos ? 0 : text.size() - point - 1;
  if (point != std::string::npos) text.erase(point, 1);
  mpq_class value(mpz_class(text, 10), mpz_class("1" + std::string(places, '0')));
  value.canonicalize();
  return value;
}

// Random digits of all sizes, and sums that nearly cancel.
TEST(LatticeAlpha, IsTheDecimalItself) {
  Random random(1);
  const mpq_class unit(1, mpz_class("9007199254740992"));  // 2^-53
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const int digits = random_int(random, 0, 6);
    std::string text = random() % 2 ? "-" : "";
    const int whole = random_int(random, 0, 24), places = random_int(random, 0, 18);
    std::int64_t weight = random_int(random, 0, kMaxLatticeRadius);
    weight *= weight;
    std::string number = "0";
    for (int n = 0; n < whole; ++n) number += static_cast<char>('0' + random() % 10);
    number += ".0";
    for (int n = 1; n < places; ++n) number += static_cast<char>('0' + random() % 10);
    if (random() % 3 == 0) {  // near -weight
      mpz_class parts = mpz_class(std::to_string(weight)) * mpz_class("1000000000000000000");
      const int bits = random_int(random, 0, 62);
      parts -= mpz_class(std::to_string(static_cast<std::int64_t>(random()) >> (62 - bits) / 2));
      const int shift = 18 + 2 * digits;
      mpz_class scale;
      mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(2 * digits));
      text = "-";
      number = mpz_class(abs(parts) / scale * scale).get_str() + "e-" + std::to_string(shift);
    }
    const Alpha angstrom2 = alpha_of(text + number);
    const LatticeAlpha alpha = Lattice{digits}.alpha_on_lattice(angstrom2);
    mpq_class expected(mpz_class("0"));
    {
      std::string exact = angstrom2.digits();
      const std::size_t point = exact.find('.');
      std::size_t fraction = 0;
      if (point != std::string::npos) {
        fraction = exact.size() - point - 1;
        exact.erase(point, 1);
      }
      expected =
          mpq_class(mpz_class(exact, 10) *
                        mpz_class("1" + std::string(static_cast<std::size_t>(2 * digits), '0')),
                    mpz_class("1" + std::string(fraction, '0')));
      expected.canonicalize();
    }
    SCOPED_TRACE(angstrom2.digits() + " on " + std::to_string(digits));
    ASSERT_EQ(rational(alpha), expected);
    ASSERT_LE(mpq_class(alpha.below), expected);
    ASSERT_GE(mpq_class(alpha.above), expected);
    if (!alpha.is_double()) {
      ASSERT_EQ(std::nextafter(alpha.below, HUGE_VAL), alpha.above);
    }
    // Finds the nearest float by comparing with the midpoints to both neighbours.
    const float rounded = alpha.nearest_float();
    for (const float other :
         {std::nextafterf(rounded, HUGE_VALF), std::nextafterf(rounded, -HUGE_VALF)}) {
      const mpq_class half =
          (mpq_class(static_cast<double>(rounded)) + mpq_class(static_cast<double>(other))) / 2;
      ASSERT_TRUE(other > rounded ? expected <= half : expected >= half);
    }
    const mpq_class sum = expected + mpz_class(std::to_string(weight));
    const mpq_class found(alpha.plus(weight));
    ASSERT_EQ(sgn(found), sgn(sum));
    ASSERT_LE(abs(found - sum), 3 * unit * abs(sum));
  }
}

// Ties between floats: 2^24 + 1 square units are exactly between two floats.
TEST(LatticeAlpha, IsRoundedToAFloatOnce) {
  const Lattice whole{0};
  EXPECT_EQ(whole.alpha_on_lattice(alpha_of("16777217")).nearest_float(), 16777216.0f);
  EXPECT_EQ(whole.alpha_on_lattice(alpha_of("16777217.000000000000000001")).nearest_float(),
            16777218.0f);
  EXPECT_EQ(whole.alpha_on_lattice(alpha_of("16777218.999999999999999999")).nearest_float(),
            16777218.0f);
  EXPECT_EQ(whole.alpha_on_lattice(alpha_of("-16777217.000000000000000001")).nearest_float(),
            -16777218.0f);
}

TEST(LatticeAlpha, GoesBackToSquareAngstrom) {
  for (const char* text : {"1.4", "-0.5", "0", "1.00000265201025", "0.100000000000000001", "1e24",
                           "-123456.789012345678901234"}) {
    for (const int digits : {0, 3, 6}) {
      const Lattice lattice{digits};
      EXPECT_EQ(lattice.alpha_angstrom2(lattice.alpha_on_lattice(alpha_of(text))), alpha_of(text))
          << text << " on " << digits;
    }
  }
}

}  // namespace
}  // namespace alphascope
