// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the order of a filtration against rational arithmetic, and against its own rules.
#include "core/triangulation/filtration_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;
using testing::Rational;
using testing::RationalOracle;
using Simplex = std::vector<BallIndex>;

Simplex balls_of(const AlphaComplex& complex, const SimplexPlace& place) {
  const auto of = [&](const auto& list) {
    const auto& simplex = list.simplices[place.index];
    return Simplex(simplex.begin(), simplex.end());
  };
  return place.dimension == 0   ? of(complex.vertices)
         : place.dimension == 1 ? of(complex.edges)
         : place.dimension == 2 ? of(complex.triangles)
                                : of(complex.tetrahedra);
}

std::vector<Simplex> order_of(const BallSet& balls) {
  const Filtration filtration(std::make_shared<const BallSet>(balls), make_triangulation(balls, 1));
  std::vector<Simplex> order;
  for (const SimplexPlace& place : filtration_order(balls, filtration.top()))
    order.push_back(balls_of(filtration.top(), place));
  return order;
}

std::vector<Simplex> expected_order(const BallSet& balls, std::size_t& of_one_float) {
  const RationalOracle oracle(balls);
  std::vector<std::pair<Rational, Simplex>> all;
  for (const auto& [simplex, value] : oracle.alpha_values()) all.push_back({value, simplex});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    if (a.second.size() != b.second.size()) return a.second.size() < b.second.size();
    return a.second < b.second;
  });
  std::vector<Simplex> order;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (n > 0 && all[n - 1].first != all[n].first)
      of_one_float +=
          testing::nearest_float(all[n - 1].first) == testing::nearest_float(all[n].first);
    order.push_back(all[n].second);
  }
  return order;
}

TEST(FiltrationOrder, IsThatOfExactValues) {
  Random random(41);
  std::size_t of_one_float = 0;
  for (int round = 0; round < 60; ++round) {
    // A distant ball, whose simplices have values of one float; and small lattices with many ties.
    BallSet far = testing::random_balls(random, 7, 2, 1, 2);
    testing::add_ball(far, 500000000 - round, 12, 7, 1);
    for (const BallSet& balls : {far, testing::random_balls(random, 9, 4, 1, 3),
                                 testing::random_balls(random, 9, 50, 5, 20)})
      ASSERT_EQ(order_of(balls), expected_order(balls, of_one_float)) << "round " << round;
  }
  EXPECT_GT(of_one_float, 60u);
}

TEST(FiltrationOrder, OfFlatSetsIsThatOfExactValues) {
  BallSet line, plane;
  for (int n = 0; n < 6; ++n) testing::add_ball(line, 3 * n, 6 * n, -3 * n, 1 + n % 3);
  for (int n = 0; n < 9; ++n) testing::add_ball(plane, n % 3, n / 3, 5, 2 + n % 2);
  std::size_t unused = 0;
  EXPECT_EQ(order_of(line), expected_order(line, unused));
  EXPECT_EQ(order_of(plane), expected_order(plane, unused));
  EXPECT_TRUE(order_of({}).empty());
}

// An engine may say -0 of a ball of radius 0. Ball 1 attaches ball 0, whose value is 0.
TEST(FiltrationOrder, ZeroHasNoSign) {
  BallSet balls;
  testing::add_ball(balls, 1, 0, 0, 1);
  testing::add_ball(balls, 0, 0, 0, 2);
  testing::add_ball(balls, 10, 0, 1, 0);
  testing::add_ball(balls, 5, 5, 5, 1);
  testing::add_ball(balls, 2, 9, -4, 1);
  const Filtration filtration(std::make_shared<const BallSet>(balls), make_triangulation(balls, 1));
  AlphaComplex complex = filtration.top();
  ASSERT_EQ(complex.vertices.alpha_values[0], 0);
  ASSERT_EQ(complex.vertices.alpha_values[2], 0);
  complex.vertices.alpha_values[2] = -0.0f;
  std::vector<Simplex> order;
  for (const SimplexPlace& place : filtration_order(balls, complex))
    order.push_back(balls_of(complex, place));
  std::size_t unused = 0;
  EXPECT_EQ(order, expected_order(balls, unused));
}

// Of large sets: every beginning is closed, and the order does not depend on threads.
TEST(FiltrationOrder, FacesComeBeforeTheirCofaces) {
  Random random(42);
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    const Filtration filtration(std::make_shared<const BallSet>(set.balls),
                                make_triangulation(set.balls, 1));
    const AlphaComplex& all = filtration.top();
    std::vector<SimplexPlace> order;
    WorkThreads(1).run([&] { order = filtration_order(set.balls, all); });
    WorkThreads(4).run([&] { EXPECT_EQ(filtration_order(set.balls, all), order) << set.name; });
    std::map<Simplex, std::size_t> place_of;
    for (std::size_t n = 0; n < order.size(); ++n) place_of[balls_of(all, order[n])] = n;
    ASSERT_EQ(place_of.size(), order.size()) << set.name;
    for (const auto& [simplex, place] : place_of) {
      for (std::size_t k = 0; k < simplex.size() && simplex.size() > 1; ++k) {
        Simplex face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
        ASSERT_LT(place_of.at(face), place) << set.name;
      }
    }
  }
}

TEST(FiltrationOrder, NeedsAWholeComplexAndCanBeCancelled) {
  AlphaComplex only;
  only.tetrahedra_only = true;
  EXPECT_THROW(filtration_order({}, only), std::invalid_argument);
  Random random(43);
  const BallSet balls = testing::random_balls(random, 500, 1000, 50, 200);
  const Filtration filtration(std::make_shared<const BallSet>(balls), make_triangulation(balls, 1));
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(filtration_order(balls, filtration.top(), cancel), Cancelled);
}

}  // namespace
}  // namespace alphascope
