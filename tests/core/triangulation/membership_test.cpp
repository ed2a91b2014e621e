// SPDX-License-Identifier: GPL-3.0-or-later
// Tests marks of K_alpha, from a filtration and from the triangulation alone, against the complex.
#include "core/triangulation/membership.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/predicates/flow_ties.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

template <int N>
Simplices<N> marked(const Simplices<N>& all, const Membership::Marks& marks) {
  Simplices<N> found;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (marks[n]) found.push_back(all[n]);
  }
  return found;
}

::testing::AssertionResult marks_are(const Membership& in, const Triangulation& triangulation,
                                     const Incidence& incidence, const AlphaComplex& complex) {
  Simplices<1> vertices;
  for (BallIndex v = 0; v < in.vertices.size(); ++v) {
    if (in.vertices[v]) vertices.push_back({v});
  }
  const bool same =
      marked<4>(triangulation.tetrahedra, in.tetrahedra) == complex.tetrahedra.simplices &&
      marked<3>(incidence.triangles, in.triangles) == complex.triangles.simplices &&
      marked<2>(incidence.edges, in.edges) == complex.edges.simplices &&
      vertices == complex.vertices.simplices;
  if (!same) return ::testing::AssertionFailure() << "at alpha " << complex.alpha_on_lattice.text();
  const std::array<std::size_t, 4> counts{complex.vertices.size(), complex.edges.size(),
                                          complex.triangles.size(), complex.tetrahedra.size()};
  return in.counts() == counts ? ::testing::AssertionSuccess()
                               : ::testing::AssertionFailure() << "counts";
}

TEST(Membership, IsTheComplexAtAlphaValuesAndBetween) {
  Random random(91);
  std::vector<NamedBalls> sets = testing::large_hard_sets(random, 300);
  for (NamedBalls& set : testing::small_hard_sets(random, 12)) sets.push_back(std::move(set));
  std::size_t compared = 0;
  for (const NamedBalls& set : sets) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const Triangulation triangulation = make_triangulation(*balls, 1);
    if (triangulation.dimension < 3) continue;
    const Incidence incidence = make_incidence(triangulation);
    const Filtration filtration(balls, triangulation);
    std::vector<double> alphas{-1e300, 0, 1e300, std::numeric_limits<double>::infinity()};
    const auto& values = filtration.top().edges.alpha_values;
    for (std::size_t n = 0; n < values.size(); n += values.size() / 12 + 1) {
      alphas.push_back(values[n]);
      alphas.push_back(std::nextafter(values[n], -1e30f));
    }
    for (const FlowTies ties : {FlowTies::perturbed, FlowTies::strict}) {
      const Flow flow = make_flow(*balls, triangulation, ties);
      for (const double alpha : alphas) {
        const AlphaComplex complex = threshold(filtration, alpha, false);
        ASSERT_TRUE(marks_are(membership(*balls, triangulation, incidence, flow, alpha),
                              triangulation, incidence, complex))
            << set.name;
        ASSERT_TRUE(marks_are(membership(filtration, alpha), triangulation, incidence, complex))
            << set.name;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000u);
}

// Values near 6e16 that differ by less than the distance of floats there.
TEST(Membership, SeparatesValuesOfOneFloat) {
  Random random(92);
  std::size_t separated = 0;
  for (int round = 0; round < 40; ++round) {
    BallSet set = testing::random_balls(random, 7, 2, 1, 2);
    testing::add_ball(set, 500000000 - round, 12, 7, 1);
    const auto balls = std::make_shared<const BallSet>(set);
    const Triangulation triangulation = make_triangulation(*balls, 1);
    const Incidence incidence = make_incidence(triangulation);
    const Flow flow = make_flow(*balls, triangulation, FlowTies::perturbed);
    const Filtration filtration(balls, triangulation);
    const testing::RationalOracle oracle(*balls);
    std::vector<mpq_class> values;
    for (const auto& [simplex, value] : oracle.alpha_values()) values.push_back(value);
    std::sort(values.begin(), values.end());
    for (std::size_t n = 0; n + 1 < values.size(); ++n) {
      const double alpha = mpq_class((values[n] + values[n + 1]) / 2).get_d();
      if (!(values[n] <= mpq_class(alpha) && mpq_class(alpha) < values[n + 1])) continue;
      separated += testing::nearest_float(values[n]) == testing::nearest_float(values[n + 1]);
      const AlphaComplex expected = oracle.complex(alpha);
      ASSERT_TRUE(marks_are(membership(*balls, triangulation, incidence, flow, alpha),
                            triangulation, incidence, expected));
      ASSERT_TRUE(marks_are(membership(filtration, alpha), triangulation, incidence, expected));
    }
  }
  EXPECT_GT(separated, 30u);
}

TEST(Membership, NeedsAWholeTriangulationOfDimension3) {
  BallSet plane;
  for (int n = 0; n < 5; ++n) testing::add_ball(plane, n * n, n, 0, 2);
  const auto balls = std::make_shared<const BallSet>(plane);
  const Triangulation flat = make_triangulation(plane, 1);
  EXPECT_THROW(membership(plane, flat, {}, {}, 0), std::invalid_argument);
  EXPECT_THROW(membership(Filtration(balls, flat), 0), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
