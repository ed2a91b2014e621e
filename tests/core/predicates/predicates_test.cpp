// SPDX-License-Identifier: GPL-3.0-or-later
// Tests decisions and brackets of the predicates against rationals. Cases are random and
// near-degenerate, from single lattice units to the bounds of the lattice.
#include <gtest/gtest.h>

#include <cmath>

#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/foot_predicate.hpp"
#include "core/predicates/perturbation.hpp"
#include "tests/support/five_balls.hpp"
#include "tests/support/reference/oracle_check.hpp"
#include "tests/support/reference/predicate_check.hpp"
#include "tests/support/reference/rational_oracle.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::Orthosphere;
using testing::Random;
using testing::random_int;
using testing::Rational;

int sign_of_rational(const Rational& value) {
  return sgn(value);
}

bool independent(const BallSet& balls, int count) {
  const LiftedInt a = lifted_vector(balls, 0, 1), b = lifted_vector(balls, 0, 2),
                  c = lifted_vector(balls, 0, 3);
  if (count == 4) return determinant(a, b, c) != 0;
  const auto n = cross(a, b);
  return count < 3 || n.x != 0 || n.y != 0 || n.z != 0;
}

LiftedVector<double> as_double(const LiftedInt& v) {
  return lifted_as<double>(v);
}

// Counts each kind of decision, so that a test that misses one fails.
struct Seen {
  std::size_t cases = 0, ties = 0, filtered = 0;
};

void expect_bracket_holds(const BallSet& balls, int count, const Rational& rho) {
  const double weight = static_cast<double>(balls.weight(0));
  LiftedInt v[3];
  for (int n = 0; n + 1 < count; ++n) {
    v[n] = lifted_vector(balls, 0, static_cast<BallIndex>(n + 1));
    if (!within_bracket_limit(v[n])) return;
  }
  const Bracket bracket =
      count == 2   ? edge_rho(as_double(v[0]), weight)
      : count == 3 ? triangle_rho(as_double(v[0]), as_double(v[1]), weight)
                   : tetrahedron_rho(as_double(v[0]), as_double(v[1]), as_double(v[2]), weight);
  if (std::isinf(bracket.error)) return;
  ASSERT_LE(abs(rho - Rational(bracket.value)), Rational(bracket.error));
}

void check_ortho_radius(const BallSet& balls, int count, Random& random, Seen& seen) {
  const BallIndex all[4] = {0, 1, 2, 3};
  const std::span<const BallIndex> simplex(all, static_cast<std::size_t>(count));
  const Orthosphere sphere = testing::orthosphere(balls, simplex);
  ++seen.cases;
  ASSERT_EQ(ortho_radius_rounded(balls, simplex), testing::nearest_float(sphere.rho));
  if (count > 1) expect_bracket_holds(balls, count, sphere.rho);

  const double near = sphere.rho.get_d();
  for (const double alpha : {near, std::nextafter(near, 1e300), std::nextafter(near, -1e300),
                             near + random_int(random, -9, 9), double(float(near)), 0.0}) {
    // Skips alphas smaller than any on the lattice, and infinite ones, which are no rationals.
    if ((std::fabs(alpha) < 1e-30 && alpha != 0) || std::isinf(alpha)) continue;
    const int expected = sign_of_rational(sphere.rho - Rational(alpha));
    ASSERT_EQ(compare_ortho_radius(balls, simplex, alpha), expected) << "alpha " << alpha;
    seen.ties += expected == 0;
  }
  for (BallIndex m = static_cast<BallIndex>(count); count < 4 && m < 5; ++m) {
    const int expected = sign_of_rational(testing::power_excess(balls, sphere, m));
    ASSERT_EQ(conflict_with_smallest_orthosphere(balls, simplex, m), expected);
    seen.ties += expected == 0;
  }
}

// Tests the filters alone: a sign that they give must be right.
void check_filters(const BallSet& balls, Seen& seen) {
  LiftedInt v[5];
  for (BallIndex n = 1; n < 5; ++n) v[n] = lifted_vector(balls, 0, n);
  for (int n = 1; n < 5; ++n) {
    if (!within_bracket_limit(v[n])) return;
  }
  const int edge = edge_foot_cut_filtered(as_double(v[1]), as_double(v[4]));
  if (edge != 0) {
    ++seen.filtered;
    ASSERT_EQ(edge, edge_foot_cut_exact(v[1], v[4]));
  }
  const LiftedInt back = lifted_vector(balls, 1, 0), between = lifted_vector(balls, 1, 4);
  if (within_bracket_limit(between)) {
    const auto jk = as_double(between);
    signed char cut[3];
    edge_foot_cuts_filtered(as_double(v[1]), as_double(v[4]), {jk.x, jk.y, jk.z}, cut);
    const int exact[3] = {edge_foot_cut_exact(between, back), edge_foot_cut_exact(v[4], v[1]),
                          edge_foot_cut_exact(v[1], v[4])};
    for (int n = 0; n < 3; ++n) {
      if (cut[n] == 0) continue;
      ++seen.filtered;
      ASSERT_EQ(cut[n], exact[n]) << "edge without ball " << n;
    }
  }
  const int triangle =
      triangle_foot_cut_filtered(as_double(v[1]), as_double(v[2]), as_double(v[4]));
  if (triangle != 0 && independent(balls, 3)) {
    ASSERT_EQ(triangle, triangle_foot_cut_exact(v[1], v[2], v[4]));
  }
}

// The orthocentre of 0123 as an end of the dual edge of 012, cut by 4.
void check_orthocentre(const BallSet& balls, Seen& seen) {
  const BallIndex simplex[4] = {0, 1, 2, 3};
  const Orthosphere sphere = testing::orthosphere(balls, simplex);
  const int excess = -sign_of_rational(testing::power_excess(balls, sphere, 4));
  const LiftedInt j = lifted_vector(balls, 0, 1), k = lifted_vector(balls, 0, 2),
                  l = lifted_vector(balls, 0, 3), m = lifted_vector(balls, 0, 4);
  const int cut = excess != 0 ? excess : testing::perturbed_conflict(balls, simplex, 4) ? 1 : -1;
  ASSERT_EQ(orthocentre_cut<WideInt<4>>(j, k, {3, l}, m), cut);
  if (excess != 0) return;
  ++seen.ties;
  ASSERT_EQ(perturbed_cut(j, k, false, l, false, m), cut);
  ASSERT_EQ(perturbed_cut(j, l, false, k, false, m), cut);
}

void check_predicates(std::uint64_t seed, int cases_per_kind) {
  Random random(seed);
  for (int kind = 0; kind < testing::kFiveBallKinds; ++kind) {
    Seen radii, filters, corners;
    for (int n = 0; n < cases_per_kind; ++n) {
      const BallSet balls = testing::five_balls(random, kind);
      const int count = 1 + n % 4;
      if (independent(balls, count)) check_ortho_radius(balls, count, random, radii);
      check_filters(balls, filters);
      if (independent(balls, 4)) check_orthocentre(balls, corners);
      if (::testing::Test::HasFatalFailure()) {
        ADD_FAILURE() << testing::kind_of_five(kind) << ", count " << count
                      << testing::list_balls(balls);
        return;
      }
    }
    EXPECT_GT(radii.cases, cases_per_kind / 2u) << "kind " << kind;
    if (kind < 3) {
      EXPECT_GT(filters.filtered, cases_per_kind / 2u) << "kind " << kind;
    }
    if (kind == 0) {
      EXPECT_GT(corners.ties, cases_per_kind / 200u);
    }
    ::testing::Test::RecordProperty("corner_ties_" + std::to_string(kind),
                                    std::to_string(corners.ties));
  }
}

TEST(Predicates, AgreeWithRationals) {
  check_predicates(1, testing::unless_sanitized(4000, 1000));
}

// Filters are tested as well, up to their proven bounds.
TEST(Predicates, AgreeWithGmp) {
  testing::PredicateCheck check(5);
  for (std::uint64_t n = 0; n < 16 * 500; ++n) check.check(n);
  EXPECT_EQ(check.wrong(), 0u) << check.failure();
  for (const auto& [name, count] : check.counts()) {
    EXPECT_GT(count.calls - count.undecided, count.calls / 10) << name;
    EXPECT_GT(count.calls, 1000u) << name;
  }
}

// A quarter of a unit decides which float is nearest. No double of this size has such quarters.
TEST(Predicates, QuartersAbove2To51AreKept) {
  BallSet balls;
  balls.lattice.digits = 6;
  testing::add_ball(balls, 0, 0, 0, 67108863);
  testing::add_ball(balls, 2, 1, 0, 67108863);
  const BallIndex edge[2] = {0, 1};
  EXPECT_EQ(ortho_radius_rounded(balls, edge),
            testing::nearest_float(testing::orthosphere(balls, edge).rho));
}

// Balls i at the origin, j and m, in all directions along the line.
TEST(Predicates, ATieAtAnEdgesFootIsBesideBetweenOrOutside) {
  const std::int64_t lines[][3] = {{2, 0, 0}, {0, -2, 0}, {0, 0, 2}, {-2, 4, -6}, {0, 2, -2}};
  for (const auto& d : lines) {
    const auto at = [&](std::int64_t halves) {
      return LiftedInt{d[0] / 2 * halves, d[1] / 2 * halves, d[2] / 2 * halves, 0};
    };
    const LiftedInt j = at(2);
    EXPECT_EQ(edge_tie(j, at(1)), EdgeTie::between);
    EXPECT_EQ(edge_tie(j, at(-1)), EdgeTie::outside);
    EXPECT_EQ(edge_tie(j, at(3)), EdgeTie::outside);
    LiftedInt m = at(1);
    (d[0] == 0 ? m.x : m.z) += 1;
    EXPECT_EQ(edge_tie(j, m), EdgeTie::beside);
  }
}

TEST(Predicates, AgreeWithRationalsLong) {
  check_predicates(2, 600000);
}

mpz_class as_integer(const WideInt<8>& value) {
  if (value.sign() < 0) return -as_integer(-value);
  mpz_class result = 0;
  for (int n = 7; n >= 0; --n) {
    result <<= 64;
    result += mpz_class(std::to_string(value.limb[n]));
  }
  return result;
}

WideInt<8> random_wide(Random& random, int limbs) {
  WideInt<8> value(0);
  for (int n = 0; n < limbs; ++n) {
    const int pattern = random_int(random, 0, 3);
    value.limb[n] = pattern == 0 ? 0 : pattern == 1 ? ~std::uint64_t{0} : random();
  }
  return random_int(random, 0, 1) ? value : -value;
}

mpz_class as_integer(Int128 value) {
  const auto low = static_cast<std::uint64_t>(value);
  return (mpz_class(std::to_string(static_cast<std::int64_t>(value >> 64))) << 64) +
         mpz_class(std::to_string(low));
}

// Values of up to 127 bits and a sign, often at the ends of the range.
Int128 random_int128(Random& random) {
  const WideInt<8> wide = random_wide(random, 2);
  const auto magnitude =
      static_cast<Int128>(static_cast<UInt128>(wide.limb[1] >> 1) << 64 | wide.limb[0]) >>
      random_int(random, 0, 126);
  return random_int(random, 0, 1) ? magnitude : -magnitude;
}

TEST(WideInt, CountsLikeGmp) {
  Random random(4);
  for (int n = 0; n < 20000; ++n) {
    const WideInt<8> a = random_wide(random, random_int(random, 1, 4)),
                     b = random_wide(random, random_int(random, 1, 3));
    const mpz_class x = as_integer(a), y = as_integer(b);
    ASSERT_EQ(as_integer(a + b), x + y);
    ASSERT_EQ(as_integer(a - b), x - y);
    ASSERT_EQ(as_integer(a * b), x * y);
    const auto factor = static_cast<std::int64_t>(random());
    ASSERT_EQ(as_integer(a.times(factor)), x * mpz_class(std::to_string(factor)));
    const Int128 root = random_int128(random);
    ASSERT_EQ(as_integer(WideInt<8>(square_of(root))), as_integer(root) * as_integer(root));
    ASSERT_EQ(a.sign(), sgn(x));
    const int bits = random_int(random, 0, 250);
    ASSERT_EQ(as_integer(a.shifted_left(bits)), x << bits);
    const Rational error = abs(Rational(a.near_double()) - Rational(x));
    ASSERT_LE(error * Rational(mpz_class(1) << 51), abs(Rational(x)));
  }
}

}  // namespace
}  // namespace alphascope
