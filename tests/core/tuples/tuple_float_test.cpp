// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the epsilon band of kernel II. Decisions of single precision must be those of integers, on
// random and nearly degenerate tuples.
#include "core/tuples/tuple_float.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/predicates/exact_alpha.hpp"
#include "core/tuples/tuple_exact.hpp"

namespace alphascope {
namespace {

struct Tally {
  std::size_t decided = 0, unknown = 0, wrong = 0;
  void add(int sign, int exact) {
    ++(sign == 0 ? unknown : decided);
    wrong += sign != 0 && sign != exact;
  }
  double decided_share() const {
    return static_cast<double>(decided) / static_cast<double>(decided + unknown);
  }
};

// Five balls of small integers times `scale`, shaken by `shake` units. A small `spread` gives many
// ties. A large scale with a small shake is nearly degenerate.
std::array<BallRecord, 5> five_balls(std::mt19937& random, int spread, int scale, int shake) {
  std::uniform_int_distribution<int> at(-spread, spread), off(-shake, shake), radius(1, spread);
  std::array<BallRecord, 5> balls;
  for (BallRecord& b : balls) {
    b = {at(random) * scale + off(random), at(random) * scale + off(random),
         at(random) * scale + off(random), radius(random) * scale + std::abs(off(random))};
  }
  return balls;
}

template <int K>
FloatCentre centre(const std::array<BallRecord, 5>& b) {
  if constexpr (K == 1) return float_centre(float_lifted(b[0], b[1]));
  if constexpr (K == 2) return float_centre(float_lifted(b[0], b[1]), float_lifted(b[0], b[2]));
  if constexpr (K == 3) {
    return float_centre(float_lifted(b[0], b[1]), float_lifted(b[0], b[2]),
                        float_lifted(b[0], b[3]));
  }
}

bool distinct(const std::array<BallRecord, 5>& b) {
  for (int p = 0; p < 5; ++p) {
    for (int q = 0; q < p; ++q) {
      if (b[p].x == b[q].x && b[p].y == b[q].y && b[p].z == b[q].z) return false;
    }
  }
  return true;
}

// Sign of 2 d_m·x - c_m at the orthocentre of K + 1 balls, without breaking ties.
template <int K>
int exact_side(const LiftedInt (&v)[K], const LiftedInt& m) {
  if constexpr (K == 1) return edge_foot_cut_exact(v[0], m);
  if constexpr (K == 2) return triangle_foot_cut_exact(v[0], v[1], m);
  if constexpr (K == 3) {
    using Wide = WideInt<4>;
    const ExactCentre<3, Wide> e(v);
    const auto w = lifted_as<Wide>(m);
    return (dot(w, e.n) - w.c * e.d).sign() * e.d.sign();
  }
}

template <int K>
void check_tuples(int spread, int scale, int shake, double least_share) {
  std::mt19937 random(1000u * static_cast<unsigned>(spread) +
                      static_cast<unsigned>(10 * scale + shake + K));
  Tally conflicts, sizes;
  for (int round = 0; round < 10000; ++round) {
    const auto b = five_balls(random, spread, scale, shake);
    if (!distinct(b)) continue;
    LiftedInt v[K];
    for (int n = 0; n < K; ++n) v[n] = lifted_from(b[0], b[n + 1]);
    const FloatCentre c = centre<K>(b);
    if (!ExactCentre<K, WideInt<4>>(v).regular()) {
      EXPECT_FALSE(c.error < HUGE_VALF) << "a degenerate tuple has no centre";
      continue;
    }
    const FloatConflict conflict(c);
    conflicts.add(conflict.side(b[0], b[4]), exact_side<K>(v, lifted_from(b[0], b[4])));
    EXPECT_EQ(conflict.side(b[0], b[1]), 0) << "a ball of the tuple itself has equal power";

    // Alphas at the ortho-radius and around it.
    const std::int64_t weight = std::int64_t{b[0].radius} * b[0].radius;
    LiftedSimplex<K + 1> simplex{{}, weight};
    std::copy(v, v + K, simplex.v);
    const ExactRho exact_rho_of_it = exact_rho(simplex);
    const double rho =
        exact_rho_of_it.numerator.near_double() / exact_rho_of_it.denominator.near_double();
    for (const double factor : {0.9, 0.999999, 1.0, 1.000001, 1.1}) {
      const float alpha = static_cast<float>(rho * factor);
      const int exact = compare_exact(exact_rho_of_it, alpha) <= 0 ? 1 : -1;
      sizes.add(static_cast<int>(centre_within(c, b[0].radius, alpha)), exact);
    }
  }
  EXPECT_EQ(conflicts.wrong, 0u);
  EXPECT_EQ(sizes.wrong, 0u);
  EXPECT_GT(conflicts.decided_share(), least_share);
  EXPECT_GT(sizes.decided, 500u);
}

TEST(TupleFloat, NeverDecidesWrongly) {
  check_tuples<1>(3000, 1, 0, 0.999);
  check_tuples<2>(3000, 1, 0, 0.99);
  check_tuples<3>(3000, 1, 0, 0.98);
}

TEST(TupleFloat, NeverDecidesTiesAndNearTies) {
  for (const int spread : {1, 2, 4}) {
    for (const auto& [scale, shake] : {std::pair(1, 0), {1000, 0}, {1000, 1}, {100000, 1}}) {
      check_tuples<1>(spread, scale, shake, 0.3);
      check_tuples<2>(spread, scale, shake, 0.2);
      check_tuples<3>(spread, scale, shake, 0.1);
    }
  }
}

// Differences up to 2^24 units, up to which floats are exact.
TEST(TupleFloat, HoldsUpToItsLimit) {
  check_tuples<1>(4000000, 1, 0, 0.99);
  check_tuples<2>(4000000, 1, 0, 0.99);
  check_tuples<3>(4000000, 1, 0, 0.98);
}

}  // namespace
}  // namespace alphascope
