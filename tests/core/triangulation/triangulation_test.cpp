// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the triangulation of hard sets of balls. It is proved from the definition, and equals those
// of rationals and of CGAL used directly.
#include "core/complex/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/verify/verify_triangulation.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/cgal_reference.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;
using testing::RationalOracle;

std::string proved(const BallSet& balls, const Triangulation& triangulation) {
  const Verification verification = verify_triangulation(balls, triangulation);
  return verification.ok() ? "" : verification.messages.at(0);
}

TEST(Triangulation, OfHardSetsIsProved) {
  Random random(31);
  std::array<int, 5> sets_of_dimension{};
  for (int round = 0; round < 4; ++round) {
    std::vector<NamedBalls> sets = testing::large_hard_sets(random);
    for (NamedBalls& set : testing::small_hard_sets(random, 12)) sets.push_back(std::move(set));
    for (const NamedBalls& set : sets) {
      const Triangulation triangulation = make_triangulation(set.balls, 1);
      ASSERT_EQ(proved(set.balls, triangulation), "") << set.name;
      ++sets_of_dimension[static_cast<std::size_t>(triangulation.dimension + 1)];
    }
  }
  for (const int sets : sets_of_dimension) EXPECT_GT(sets, 0);
}

// All simplices of N balls that the rational oracle finds.
template <int N>
Simplices<N> of_size(const RationalOracle& oracle) {
  Simplices<N> found;
  for (const auto& [simplex, value] : oracle.alpha_values()) {
    if (simplex.size() != N) continue;
    std::array<BallIndex, N> s{};
    std::copy(simplex.begin(), simplex.end(), s.begin());
    found.push_back(s);
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Triangulation, OfSmallHardSetsEqualsTheDefinitionInRationals) {
  Random random(32);
  std::size_t simplices = 0;
  for (int round = 0; round < 4; ++round) {
    for (const NamedBalls& set : testing::small_hard_sets(random, 9)) {
      const RationalOracle oracle(set.balls);
      const Triangulation found = make_triangulation(set.balls, 1);
      Simplices<1> vertices;
      for (const BallIndex v : found.vertices) vertices.push_back({v});
      EXPECT_EQ(vertices, of_size<1>(oracle)) << set.name;
      EXPECT_EQ(found.tetrahedra, of_size<4>(oracle)) << set.name;
      const bool plane = found.dimension == 2, line = found.dimension == 1;
      EXPECT_EQ(found.triangles, plane ? of_size<3>(oracle) : Simplices<3>{}) << set.name;
      EXPECT_EQ(found.edges, line ? of_size<2>(oracle) : Simplices<2>{}) << set.name;
      simplices += found.tetrahedra.size() + found.triangles.size() + found.edges.size();
    }
  }
  EXPECT_GT(simplices, 1000u);
}

TEST(Triangulation, OfLargeHardSetsEqualsThatOfCgalUsedDirectly) {
  Random random(33);
  std::size_t compared = 0;
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    if (!coincident_hidden(set.balls).empty()) continue;  // CGAL chooses among equal balls
    const Triangulation found = make_triangulation(set.balls, 1);
    if (found.dimension != 3) continue;
    const double all = std::numeric_limits<double>::infinity();
    Simplices<4> expected = testing::regular_cells(set.balls, all).tetrahedra;
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found.tetrahedra, expected) << set.name;
    compared += expected.size();
  }
  EXPECT_GT(compared, 3000u);
}

// The sets have hidden and coincident balls, too.
TEST(Triangulation, DoesNotDependOnThreads) {
  Random random(23);
  for (const int high_radius : {30, 900}) {
    const BallSet balls = testing::random_balls(random, 20000, 500, 1, high_radius);
    const Triangulation one = make_triangulation(balls, 1);
    EXPECT_GT(one.hidden.size(), high_radius == 900 ? 10000u : 0u);
    EXPECT_TRUE(one == make_triangulation(balls, 4));
    EXPECT_EQ(proved(balls, one), "");
  }
}

TEST(Triangulation, ItsHullLooksOutward) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& p : {LatticePoint{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}, {1, 1, 1}}) {
    testing::add_ball(balls, p.x, p.y, p.z, 1);
  }
  const Triangulation t = make_triangulation(balls, 1);
  ASSERT_EQ(t.tetrahedra.size(), 4u);
  const std::array<BallIndex, 4> first{0, 1, 2, 4};
  EXPECT_EQ(t.tetrahedra[0], first);
  // Seen from below, with x to the right and y up, the order is clockwise, so it is 0 2 1.
  const HullFacet below{{0, 2, 1}, 0};
  EXPECT_EQ(t.hull.at(0), below);
  EXPECT_EQ(t.neighbours[0][3], Neighbour::hull_facet(0));
  EXPECT_EQ(t.neighbours[0][0], Neighbour::tetrahedron(3));  // of 1 2 3 4
}

// The making ends at any report of progress, or soon after.
TEST(Triangulation, ItsMakingCanBeCancelled) {
  Random random(34);
  const BallSet balls = testing::random_balls(random, 6000, 3000, 100, 300);
  for (const int threads : {1, 4}) {
    int reports = 0;
    RunContext counting;
    counting.progress = [&](std::string_view, double) { ++reports; };
    make_triangulation(balls, threads, counting);
    EXPECT_GE(reports, 1);
    int cancelled = 0;
    for (int last = 1; last <= reports; ++last) {
      int seen = 0;
      RunContext context;
      context.progress = [&](std::string_view, double) {
        if (++seen == last) context.cancel.cancel();
      };
      try {
        make_triangulation(balls, threads, context);
        // Only the calling thread reports, and the others may do more of the work than before.
        EXPECT_GT(threads, 1);
        EXPECT_LT(seen, last) << "it went on after it was cancelled";
      } catch (const Cancelled&) {
        ++cancelled;
        EXPECT_EQ(seen, last);
      }
    }
    EXPECT_GE(cancelled, 1);
  }
}

// The store decides by these numbers whether a result fits into the budget.
TEST(MemoryNeed, BytesAreThoseOfAllArrays) {
  Triangulation t;
  t.tetrahedra.resize(2);
  t.neighbours.resize(2);
  t.hull.resize(3);
  t.triangles.resize(4);
  t.edges.resize(5);
  t.vertices.resize(6);
  t.hidden.resize(7);
  EXPECT_EQ(bytes_of(t), 2 * 16 + 2 * sizeof(t.neighbours[0]) + 3 * sizeof(HullFacet) + 4 * 12 +
                             5 * 8 + (6 + 7) * 4);
}

TEST(MemoryNeed, OfAFiltrationIsWhatItHolds) {
  Random random(35);
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const Triangulation triangulation = make_triangulation(*balls, 1);
    const Filtration filtration(balls, triangulation);
    const MemoryNeed need = filtration_memory(triangulation);
    EXPECT_EQ(need.held, filtration.top_bytes() + filtration.level_bytes()) << set.name;
    EXPECT_GT(need.peak, need.held) << set.name;
    const Filtration sharing(balls, std::make_shared<const Triangulation>(triangulation));
    const MemoryNeed less = filtration_memory(triangulation, TetrahedraOfFiltration::shared);
    EXPECT_EQ(less.held, sharing.top_bytes() + sharing.level_bytes()) << set.name;
    EXPECT_EQ(need.held - less.held, need.peak - less.peak) << set.name;
  }
}

TEST(MemoryNeed, OfAMoleculeIsEstimatedFromItsBalls) {
  const auto balls = testing::sample_balls("1crn.pdb", 1.4);
  const Triangulation triangulation = make_triangulation(*balls, 1);
  const auto expect_near = [](std::uint64_t estimate, std::uint64_t right) {
    EXPECT_GT(estimate, right);
    EXPECT_LT(static_cast<double>(estimate), 1.5 * static_cast<double>(right));
  };
  expect_near(triangulation_memory(balls->size()).held, bytes_of(triangulation));
  expect_near(filtration_memory(balls->size()).held, filtration_memory(triangulation).held);
  expect_near(filtration_memory(balls->size()).peak, filtration_memory(triangulation).peak);
}

}  // namespace
}  // namespace alphascope
