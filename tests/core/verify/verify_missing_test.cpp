// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the verifier notices missing simplices in otherwise sound complexes, and wrongly
// broken ties.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/verify/verify.hpp"
#include "core/verify/verify_missing.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

AlphaComplex complex_at(const BallSet& balls, double alpha, bool tetrahedra_only = false) {
  return make_cgal_engine(std::make_shared<const BallSet>(balls), {1})
      ->compute({alpha, tetrahedra_only}, {});
}

// Verifies by a search and by the triangulation, which must agree.
Verification verify_both(const BallSet& balls, const AlphaComplex& complex) {
  const Verification found = verify(balls, complex, {}, VerifyBy::search),
                     proven = verify(balls, complex, {}, VerifyBy::triangulation);
  EXPECT_EQ(found.ok(), proven.ok()) << (found.ok() ? proven : found).messages.at(0);
  return found;
}

template <int N>
void keep_if(SimplexList<N>& list, const auto& keep) {
  SimplexList<N> kept;
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (!keep(list.simplices[n])) continue;
    kept.simplices.push_back(list.simplices[n]);
    if (!list.alpha_values.empty()) kept.alpha_values.push_back(list.alpha_values[n]);
    if (!list.classes.empty()) kept.classes.push_back(list.classes[n]);
  }
  list = std::move(kept);
}

bool has_all(const auto& simplex, const std::vector<BallIndex>& vertices) {
  return std::includes(simplex.begin(), simplex.end(), vertices.begin(), vertices.end());
}

// Removes a simplex and its cofaces. The rest contains all faces of its simplices, with their right
// classes.
AlphaComplex without(const AlphaComplex& complex, const std::vector<BallIndex>& vertices) {
  AlphaComplex rest = complex;
  const auto stays = [&](const auto& s) { return !has_all(s, vertices); };
  keep_if(rest.tetrahedra, stays);
  keep_if(rest.triangles, stays);
  keep_if(rest.edges, stays);
  keep_if(rest.vertices, stays);
  if (!rest.tetrahedra_only) classify(rest);
  return rest;
}

// The verifier's report on an incomplete complex, and whether it reports only missing simplices.
struct Said {
  bool noticed = false;
  bool missing_only = true;
};
Said said_of(const BallSet& balls, const AlphaComplex& damaged) {
  const Verification found = verify_both(balls, damaged);
  Said said{!found.ok(), true};
  for (const std::string& message : found.messages) {
    said.missing_only = said.missing_only && message.find("missing") != std::string::npos;
  }
  return said;
}

// For each dimension, the number of complexes where the only report is about missing simplices.
using Counts = std::array<int, 4>;

template <int N>
void expect_each_is_missed(const NamedBalls& set, const AlphaComplex& complex,
                           const SimplexList<N>& list, Random& random, Counts& found_missing) {
  constexpr std::size_t kMost = 8;
  for (std::size_t n = 0; n < std::min(kMost, list.size()); ++n) {
    const auto& s = list.simplices[random() % list.size()];
    const Said said = said_of(set.balls, without(complex, {s.begin(), s.end()}));
    ASSERT_TRUE(said.noticed) << set.name << ", " << N << " balls, the first " << s[0];
    found_missing[N - 1] += said.missing_only;
  }
}

// The verifier must notice each removal. In at least `at_least` complexes of each dimension, it
// must report nothing but missing simplices.
void expect_removals_are_noticed(const std::vector<NamedBalls>& sets, Random& random,
                                 int at_least = 20) {
  Counts found{};
  for (const NamedBalls& set : sets) {
    for (const double alpha : {-0.5, 0.0, 1.0, 2.5, 1e300}) {
      const AlphaComplex complex = complex_at(set.balls, alpha * set.alpha_unit());
      const Verification right = verify_both(set.balls, complex);
      ASSERT_TRUE(right.ok()) << set.name << ", alpha " << alpha << ": " << right.messages.at(0);
      expect_each_is_missed(set, complex, complex.vertices, random, found);
      expect_each_is_missed(set, complex, complex.edges, random, found);
      expect_each_is_missed(set, complex, complex.triangles, random, found);
      expect_each_is_missed(set, complex, complex.tetrahedra, random, found);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  for (const int count : found) EXPECT_GE(count, at_least);
}

TEST(Missing, OneSimplexOfSmallHardSetsIsNoticed) {
  Random random(51);
  for (int round = 0; round < 3; ++round) {
    expect_removals_are_noticed(testing::small_hard_sets(random, 10), random);
  }
}

TEST(Missing, OneSimplexOfLargeHardSetsIsNoticed) {
  Random random(52);
  expect_removals_are_noticed(testing::large_hard_sets(random, testing::unless_sanitized(60, 20)),
                              random);
}

// The complex of a smaller alpha is sound. Only missing simplices show the fault.
TEST(Missing, TheComplexOfASmallerAlphaIsNoticed) {
  Random random(53);
  int noticed = 0;
  std::vector<NamedBalls> sets = testing::small_hard_sets(random, 12);
  for (NamedBalls& set : testing::large_hard_sets(random, 40)) sets.push_back(std::move(set));
  for (const NamedBalls& set : sets) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const auto engine = testing::keeping(make_cgal_engine(balls, {1}));
    const double large = 3 * set.alpha_unit();
    const AlphaComplex whole = engine->compute({large}, {}),
                       tetrahedra = engine->compute({large, true}, {});
    for (const double smaller : {-1e6, -0.5, 0.0, 0.7, 1.0, 1.9, 2.5, 2.9}) {
      for (const bool only : {false, true}) {
        AlphaComplex damaged = engine->compute({smaller * set.alpha_unit(), only}, {});
        const bool equal = damaged.hash == (only ? tetrahedra : whole).hash;
        damaged.alpha_on_lattice = whole.alpha_on_lattice;
        const Said said = said_of(set.balls, damaged);
        ASSERT_EQ(said.noticed, !equal) << set.name << ", alpha " << smaller << " for 3, " << only;
        ASSERT_TRUE(said.missing_only) << set.name << ", alpha " << smaller << " for 3, " << only;
        noticed += said.noticed;
      }
    }
  }
  EXPECT_GT(noticed, 300);
}

// Two sets far apart. One gives no information on the other.
TEST(Missing, AWholeComponentIsNoticed) {
  Random random(54);
  BallSet balls = testing::random_balls(random, 40, 30, 5, 12);
  const BallIndex first_of_second = static_cast<BallIndex>(balls.size());
  for (int n = 0; n < 3; ++n) testing::add_ball(balls, 10000 + 5 * n, n % 2, 0, 4);
  for (const bool only : {false, true}) {
    AlphaComplex complex = complex_at(balls, 4, only);
    ASSERT_TRUE(verify_both(balls, complex).ok());
    const auto of_first = [&](const auto& s) { return s[0] < first_of_second; };
    keep_if(complex.tetrahedra, of_first);
    keep_if(complex.triangles, of_first);
    keep_if(complex.edges, of_first);
    keep_if(complex.vertices, of_first);
    const Said said = said_of(balls, complex);
    EXPECT_EQ(said.noticed, !only) << "three balls have no tetrahedron";
    EXPECT_TRUE(said.missing_only);
  }
}

TEST(Missing, ALoneTetrahedronIsNoticed) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& [x, y, z] : {std::tuple{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}) {
    testing::add_ball(balls, x, y, z, 6);
  }
  AlphaComplex complex = complex_at(balls, 100, true);
  ASSERT_EQ(complex.tetrahedra.size(), 1u);
  EXPECT_TRUE(verify_both(balls, complex).ok());
  complex.tetrahedra = {};
  EXPECT_TRUE(said_of(balls, complex).noticed);
}

// A missing tetrahedron is found from each of its four triangles, and these from their edges.
TEST(Missing, IsListedOnce) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& [x, y, z] : {std::tuple{0, 0, 0}, {10, 10, 0}, {10, 0, 10}, {0, 10, 10}}) {
    testing::add_ball(balls, x, y, z, 6);
  }
  const AlphaComplex whole = complex_at(balls, 100);
  const VerifyBalls at_100(balls, whole.alpha_on_lattice);
  const auto missing = [&](const AlphaComplex& part) {
    return find_missing(at_100, part, false, {});
  };
  AlphaComplex part = whole;
  part.tetrahedra = {};
  classify(part);
  EXPECT_EQ(missing(part).tetrahedra, (Simplices<4>{{0, 1, 2, 3}}));
  part.triangles = {};
  classify(part);
  EXPECT_EQ(missing(part).triangles, whole.triangles.simplices);
  part.edges = {};
  classify(part);
  EXPECT_EQ(missing(part).edges, whole.edges.simplices);
}

TEST(Missing, NothingAtAllIsNoticed) {
  Random random(55);
  const BallSet balls = testing::random_balls(random, 30, 20, 3, 9);
  AlphaComplex nothing;
  nothing.lattice = balls.lattice;
  EXPECT_FALSE(verify_both(balls, nothing).ok());
  nothing.tetrahedra_only = true;
  nothing.alpha_on_lattice = 20;
  EXPECT_FALSE(verify_both(balls, nothing).ok());
  nothing.alpha_on_lattice = -1e4;  // all balls are empty
  EXPECT_TRUE(verify_both(balls, nothing).ok());
  EXPECT_TRUE(verify_both({}, nothing).ok());
}

// A huge ball and two small ones that barely reach it, at six digits.
TEST(Missing, ATriangleOfVeryUnequalBallsIsNoticed) {
  BallSet balls;
  balls.lattice.digits = 6;
  testing::add_ball(balls, 0, 0, 0, 40000000);
  testing::add_ball(balls, 25903893, 30481935, 0, 400000);
  testing::add_ball(balls, 26508290, 29957813, 0, 400000);
  const AlphaComplex complex = complex_at(balls, 0);
  ASSERT_EQ(complex.triangles.size(), 1u);
  const Verification right = verify_both(balls, complex);
  EXPECT_TRUE(right.ok()) << right.messages.at(0);
  const Said said = said_of(balls, without(complex, {0, 1, 2}));
  EXPECT_TRUE(said.noticed);
}

// Balls at the limits of coordinates and radii, which still meet.
TEST(Missing, SimplicesAtTheLimitsOfTheLatticeAreNoticed) {
  Random random(56);
  std::vector<NamedBalls> sets;
  for (int round = 0; round < 6; ++round) {
    BallSet balls;
    balls.lattice.digits = 0;
    const int reach = kMaxLatticeRadius, corner = kMaxLatticeCoordinate - 3 * reach;
    for (int n = 0; n < 12; ++n) {
      const auto at = [&] { return corner + testing::random_int(random, 0, 3 * reach); };
      const int x = at(), y = -at(), z = at();
      testing::add_ball(balls, x, y, z, n % 3 == 0 ? testing::random_int(random, 1, 9) : reach);
    }
    sets.push_back({"limits", balls});
  }
  expect_removals_are_noticed(sets, random, 3);
}

// The mirror image of a set breaks its ties differently.
TEST(Missing, TiesBrokenOtherwiseAreNoticed) {
  Random random(57);
  int different = 0;
  for (const NamedBalls& set : testing::small_hard_sets(random, 12)) {
    BallSet mirrored = set.balls;
    for (LatticePoint& p : mirrored.centres) p.x = -p.x;
    for (const bool only : {false, true}) {
      const AlphaComplex right = complex_at(set.balls, 1e6, only),
                         wrong = complex_at(mirrored, 1e6, only);
      ASSERT_TRUE(verify_both(set.balls, right).ok()) << set.name;
      ASSERT_EQ(verify_both(set.balls, wrong).ok(), right.hash == wrong.hash) << set.name;
      different += right.hash != wrong.hash;
    }
  }
  EXPECT_GT(different, 10);
}

TEST(Missing, RightComplexesOfMoleculesPass) {
  Random random(58);
  for (const double solvent : {0.0, 1.4}) {
    const auto balls = testing::sample_balls("1crn.pdb", solvent);
    const auto engine = testing::keeping(make_cgal_engine(balls, {1}));
    for (const double alpha : {-1.0, 0.0, 1.4, 10.0, 1e300}) {
      for (const bool only : {true, false}) {
        const AlphaComplex complex = engine->compute({alpha, only}, {});
        const Verification right = verify_both(*balls, complex);
        ASSERT_TRUE(right.ok()) << alpha << ": " << right.messages.at(0);
        if (only || complex.edges.size() == 0) continue;
        const auto& lone = complex.edges.simplices[random() % complex.edges.size()];
        EXPECT_TRUE(said_of(*balls, without(complex, {lone[0], lone[1]})).noticed) << alpha;
      }
    }
  }
}

// Without any ball there is nothing to search.
TEST(Missing, NothingIsMissingWhereAllBallsAreEmpty) {
  Random random(41);
  const BallSet balls = testing::random_balls(random, 9, 10, 2, 5);
  for (const double alpha : {-25.0, -26.0, -1e9}) {  // the largest radius is 5 at most
    const AlphaComplex complex = complex_at(balls, alpha);
    EXPECT_TRUE(verify_both(balls, complex).ok()) << alpha;
  }
}

TEST(Missing, TheSearchCanBeCancelledAndTellsHowFarItIs) {
  const auto balls = testing::sample_balls("1crn.pdb", 1.4);
  const AlphaComplex complex = complex_at(*balls, 5);
  RunContext context;
  double last = -1;
  std::size_t reports = 0;
  context.progress = [&](std::string_view stage, double share) {
    EXPECT_EQ(stage, stage::kDefinition);
    EXPECT_LT(share, 1);
    last = share;
    ++reports;
  };
  EXPECT_TRUE(verify(*balls, complex, context, VerifyBy::search).ok());
  EXPECT_GE(last, 0);
  EXPECT_GE(reports, 8u);  // every kind of check
  for (std::size_t n = 0; n < reports; ++n) {
    RunContext cancelled;
    std::size_t until = n;
    cancelled.progress = [&](std::string_view, double) {
      if (until-- == 0) cancelled.cancel.cancel();
    };
    EXPECT_THROW(verify(*balls, complex, cancelled, VerifyBy::search), Cancelled) << n;
  }
}

}  // namespace
}  // namespace alphascope
