// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that alpha is the typed decimal in every engine. Simplices have a decimal ortho-radius,
// worked out by hand. They are in at that alpha, and out 10^-18 Å² below it.
#include <gtest/gtest.h>

#include <gmpxx.h>

#include <array>
#include <memory>
#include <random>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/verify/verify.hpp"
#include "tests/support/engines.hpp"
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

// The decimal numerator / 10^digits, and the decimal 10^-18 below it.
struct Decimals {
  Alpha at, below;
};
Decimals decimals(const mpz_class& numerator, int digits) {
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(18 - digits));
  const mpz_class parts = numerator * scale, less = parts - 1;
  return {alpha_of(parts.get_str() + "e-18"), alpha_of(less.get_str() + "e-18")};
}

// N balls: one at a corner, and the others 10^a units away from it along axes. With c_k = 10^2a +
// w_0 - w_k the orthocentre is c_k / (2 · 10^a) along each axis. So rho = sum of c_k² / (4 · 10^2a)
// - w_0. This is a decimal of 2a + 2 digits, 25 (sum of c_k²) - 10^(2a + 2) w_0. The orthocentre
// lies within the simplex if each c_k is between 0 and 2/3 10^2a. Larger radii of the other balls
// ensure that.
struct Corner {
  BallSet balls;
  Decimals alpha;
};
Corner random_corner(Random& random, int n, int digits, int a, std::int32_t radius) {
  Corner corner;
  corner.balls.lattice.digits = digits;
  std::int32_t step = 1;
  for (int i = 0; i < a; ++i) step *= 10;
  const mpz_class square = mpz_class(step) * step, weight = mpz_class(radius) * radius;
  const auto place = [&] {
    return random() % 2 ? kMaxLatticeCoordinate - step : random_int(random, -1000, 1000);
  };
  const LatticePoint first{place(), place(), place()};
  corner.balls.centres.push_back(first);
  corner.balls.radii.push_back(radius);
  mpz_class sum = 0;
  for (int k = 0; k < n - 1; ++k) {
    LatticePoint p = first;
    (k == 0 ? p.x : k == 1 ? p.y : p.z) += step;
    // w_k - w_0 is between a third and all of the square.
    const mpz_class least = sqrt(weight + square / 3) + 1, most = sqrt(weight + square - 1);
    const auto r = static_cast<std::int32_t>(
        random_int(random, static_cast<int>(least.get_si()), static_cast<int>(most.get_si())));
    corner.balls.centres.push_back(p);
    corner.balls.radii.push_back(r);
    const mpz_class c = square + weight - mpz_class(r) * r;
    EXPECT_GT(c, 0);
    EXPECT_LT(3 * c, 2 * square);
    sum += c * c;
  }
  corner.alpha = decimals(25 * sum - 100 * square * weight, 2 * a + 2 + 2 * digits);
  return corner;
}

std::size_t simplices(const AlphaComplex& complex, int n) {
  return n == 2   ? complex.edges.size()
         : n == 3 ? complex.triangles.size()
                  : complex.tetrahedra.size();
}

void expect_in_and_out(const testing::EngineFactory& factory, const BallSet& set, int n,
                       const Decimals& alpha) {
  const auto balls = std::make_shared<const BallSet>(set);
  const auto engine = factory.make(balls);
  AlphaComplex at = engine->compute({alpha.at}, {}), below = engine->compute({alpha.below}, {});
  EXPECT_EQ(simplices(at, n), 1u) << alpha.at.digits();
  EXPECT_EQ(simplices(below, n), 0u) << alpha.below.digits();
  // In the other order: the result kept from the larger alpha decides the smaller one.
  EXPECT_EQ(engine->compute({alpha.at}, {}).hash, at.hash);
  EXPECT_EQ(engine->compute({alpha.below}, {}).hash, below.hash);
  // The verifier tells them apart as well.
  EXPECT_TRUE(verify(set, at).ok());
  EXPECT_TRUE(verify(set, below).ok());
  std::swap(at.alpha_on_lattice, below.alpha_on_lattice);
  EXPECT_FALSE(verify(set, at).ok());
  EXPECT_FALSE(verify(set, below).ok());
  if (n < 4) return;
  EXPECT_EQ(engine->compute({alpha.at, true}, {}).tetrahedra.size(), 1u);
  EXPECT_EQ(engine->compute({alpha.below, true}, {}).tetrahedra.size(), 0u);
}

using ExactAlpha = testing::EngineSuite;

TEST_P(ExactAlpha, IncludesARadiusThatIsTheDecimal) {
  Random random(34);
  struct Size {
    int digits, a;
    std::int32_t radius;  // the least radius; up to 500 more
  };
  // 2a + 2 + 2 digits are at most 18. In the last case weights are near their bound of 2^52.
  for (const auto& [digits, a, radius] :
       {Size{3, 3, 100}, Size{3, 4, 1000}, Size{4, 3, 1000}, Size{5, 3, 10}, Size{6, 2, 10},
        Size{6, 2, 90}, Size{3, 5, kMaxLatticeRadius - 2000}}) {
    for (int n = 2; n <= 4; ++n) {
      for (int repeat = 0; repeat < 4; ++repeat) {
        const Corner corner =
            random_corner(random, n, digits, a, radius + random_int(random, 0, 500 / (a + 1)));
        SCOPED_TRACE(std::to_string(digits) + " digits, " + std::to_string(n) + " balls");
        expect_in_and_out(GetParam(), corner.balls, n, corner.alpha);
      }
    }
  }
}

// Two balls of 1 and 1.500001 Å are 2 Å apart, with six digits. They have 5 · 10^11 square units.
TEST_P(ExactAlpha, IsNotRoundedBeyondFourMilliardUnits) {
  BallSet set;
  set.lattice.digits = 6;
  set.centres = {{0, 0, 0}, {2000000, 0, 0}};
  set.radii = {1000000, 1500001};
  // c = 4·10^12 + 10^12 - 2250003000001 = 2749996999999; rho = c² / (16·10^12) - 10^12.
  const mpz_class c("2749996999999"), sixteen("16000000000000"), weight("1000000000000");
  // c² / 16·10^12 = 625 c² / 10^16, in Å² by 10^12 more. These are 28 digits, so the decimal cannot
  // be typed. Its neighbours of 18 digits can.
  const mpz_class numerator = 625 * c * c - weight * mpz_class("10000000000000000");
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), numerator.get_mpz_t(), mpz_class("10000000000").get_mpz_t());
  const Decimals alpha{alpha_of(mpz_class(floor + 1).get_str() + "e-18"),
                       alpha_of(floor.get_str() + "e-18")};
  expect_in_and_out(GetParam(), set, 2, alpha);
}

// For equal balls rho = d² / 4 - w, a quarter of a square unit beyond a whole number. For 1 Å and d
// = 3.000001 Å it is 1.25000150000025 Å². For 1 Å and d = 1.001 Å it is -0.74949975 Å².
TEST_P(ExactAlpha, IsAQuarterOfAUnit) {
  BallSet fine;
  fine.lattice.digits = 6;
  fine.centres = {{0, 0, 0}, {3000001, 0, 0}};
  fine.radii = {1000000, 1000000};
  expect_in_and_out(GetParam(), fine, 2, decimals(mpz_class("125000150000025"), 14));
  BallSet coarse;
  coarse.centres = {{0, 0, 0}, {1001, 0, 0}};
  coarse.radii = {1000, 1000};
  expect_in_and_out(GetParam(), coarse, 2, decimals(-74949975, 8));
}

// A ball of radius² w is in the complex exactly from alpha = -w on, where w + alpha nearly cancels.
TEST_P(ExactAlpha, ABallIsEmptyBelowMinusItsWeight) {
  for (const int digits : {3, 6}) {
    for (const std::int32_t radius : {1, 1880, 1234567, kMaxLatticeRadius}) {
      BallSet set;
      set.lattice.digits = digits;
      set.centres = {{0, 0, 0}};
      set.radii = {radius};
      const auto alpha = decimals(-mpz_class(radius) * radius, 2 * digits);
      const auto engine = GetParam().make(std::make_shared<const BallSet>(set));
      EXPECT_EQ(engine->compute({alpha.at}, {}).vertices.size(), 1u) << radius;
      EXPECT_EQ(engine->compute({alpha.below}, {}).vertices.size(), 0u) << radius;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ExactAlpha, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

}  // namespace
}  // namespace alphascope
