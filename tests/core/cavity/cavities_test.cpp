// SPDX-License-Identifier: GPL-3.0-or-later
// Tests cavities of small sets against their definition, computed in rational numbers. Also tests
// changes that must not affect cavities.
#include "core/cavity/cavities.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_cavities.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;
using testing::RationalCavity;

struct Found {
  CavityGround ground;
  Cavities cavities;
};

Found find(const BallSet& balls, double alpha, OutsideRule rule = OutsideRule::castp,
           FlowTies ties = FlowTies::perturbed) {
  const auto shared = std::make_shared<const BallSet>(balls);
  Found found;
  found.ground = make_cavity_ground(
      shared, std::make_shared<const Triangulation>(make_triangulation(balls, 1)), ties);
  const auto& [set, triangulation, incidence, flow] = found.ground;
  if (triangulation->dimension == 3) {
    const Membership in = membership(*set, *triangulation, incidence, flow, alpha);
    found.cavities = find_cavities(found.ground, in, rule);
  }
  return found;
}

template <std::size_t N>
testing::Simplex named(const std::array<BallIndex, N>& simplex) {
  return {simplex.begin(), simplex.end()};
}

std::set<RationalCavity> as_sets(const Found& found) {
  const Simplices<4>& tetrahedra = found.ground.triangulation->tetrahedra;
  std::set<RationalCavity> cavities;
  for (const Cavity& cavity : found.cavities.cavities) {
    RationalCavity set;
    for (const std::uint32_t t : cavity.tetrahedra) {
      set.tetrahedra.insert(named(tetrahedra[t]));
      if (found.ground.flow.is_sink(t)) set.sinks.insert(named(tetrahedra[t]));
    }
    for (const Mouth& mouth : cavity.mouths) {
      std::set<testing::Simplex> triangles;
      for (const std::uint32_t f : mouth.triangles) {
        triangles.insert(named(found.ground.incidence.triangles[f]));
      }
      set.mouths.insert(std::move(triangles));
    }
    EXPECT_EQ(cavity.sinks, set.sinks.size());
    set.deepest_sink = named(tetrahedra[cavity.deepest_sink]);
    cavities.insert(std::move(set));
  }
  return cavities;
}

// Balls on a few points of a lattice, mostly of equal radius, so every second set has ties.
BallSet lattice_balls(Random& random) {
  BallSet balls;
  std::set<std::array<int, 3>> taken;
  const int count = testing::random_int(random, 5, 11), low = testing::random_int(random, 3, 7);
  while (static_cast<int>(taken.size()) < count) {
    const std::array<int, 3> p{testing::random_int(random, 0, 2), testing::random_int(random, 0, 2),
                               testing::random_int(random, 0, 2)};
    if (!taken.insert(p).second) continue;
    testing::add_ball(balls, 6 * p[0], 6 * p[1], 6 * p[2],
                      testing::random_int(random, 0, 3) == 0 ? low + 1 : low);
  }
  return balls;
}

// An octahedron with a hole inside, closed or nearly closed, and up to three more balls.
BallSet hollow_balls(Random& random) {
  BallSet balls;
  const int radius = testing::random_int(random, 4, 5);
  for (const int at : {0, 12}) {
    testing::add_ball(balls, at, 6, 6, radius + testing::random_int(random, 0, 3) / 3);
    testing::add_ball(balls, 6, at, 6, radius);
    testing::add_ball(balls, 6, 6, at, 5);
  }
  for (int n = testing::random_int(random, 0, 3); n > 0; --n) {
    testing::add_ball(balls, 12 * (n & 1), 12 * (n / 2), testing::random_int(random, 0, 15), 5);
  }
  return balls;
}

TEST(Cavities, AreThoseOfTheDefinitionInRationals) {
  Random random(101);
  std::size_t voids = 0, pockets = 0, mouths = 0, ties = 0, rules_differ = 0, ties_matter = 0;
  const int rounds = testing::unless_sanitized(300, 75);
  for (int round = 0; round < rounds; ++round) {
    const BallSet balls = round % 4 == 0   ? testing::random_balls(random, 10, 12, 2, 7)
                          : round % 4 == 1 ? hollow_balls(random)
                                           : lattice_balls(random);
    const testing::RationalOracle oracle(balls);
    const double alpha = testing::random_int(random, -4, 2) * 4;
    std::vector<std::set<RationalCavity>> found_of;
    for (const bool castp : {true, false}) {
      for (const bool strict : {false, true}) {
        const auto expected = testing::rational_cavities(balls, oracle, alpha, strict, castp);
        const Found found = find(balls, alpha, castp ? OutsideRule::castp : OutsideRule::pocket,
                                 strict ? FlowTies::strict : FlowTies::perturbed);
        if (found.ground.triangulation->dimension < 3) continue;
        ASSERT_EQ(as_sets(found), expected.cavities) << "round " << round;
        ASSERT_EQ(found.ground.flow.ties, expected.flow_ties);
        ASSERT_EQ(found.cavities.components, expected.betti[0]);
        ASSERT_EQ(found.cavities.tunnels, expected.betti[1]);
        ASSERT_EQ(found.cavities.voids, expected.betti[2]);
        for (const Cavity& cavity : found.cavities.cavities) {
          (cavity.is_void() ? voids : pockets) += 1;
          mouths += cavity.mouths.size();
        }
        ties += expected.flow_ties > 0;
        found_of.push_back(as_sets(found));
      }
    }
    if (found_of.size() != 4) continue;
    rules_differ += found_of[0] != found_of[2];
    ties_matter += found_of[0] != found_of[1];
  }
  // Each case must occur this often in 300 rounds, and proportionally less in fewer.
  const auto share = [&](std::size_t of_all) {
    return of_all * static_cast<std::size_t>(rounds) / 300;
  };
  EXPECT_GT(voids, share(40));
  EXPECT_GT(pockets, share(400));
  EXPECT_GT(mouths, pockets + share(100));
  EXPECT_GT(ties, share(300));
  EXPECT_GT(rules_differ, share(10));
  EXPECT_GT(ties_matter, share(10));
}

// Compares the number of voids with Betti number 2, from ranks of boundary matrices modulo 2.
// Alphas are those at which the complex changes, and others between them.
TEST(Cavities, VoidsAreBetti2AtEveryAlpha) {
  Random random(104);
  std::size_t steps = 0, with_voids = 0;
  for (int round = 0; round < 24; ++round) {
    const BallSet balls = round % 2 ? hollow_balls(random) : lattice_balls(random);
    const testing::RationalOracle oracle(balls);
    std::set<double> alphas;
    for (const auto& [simplex, alpha] : oracle.alpha_values()) {
      const double value = std::floor(alpha.get_d() * 2) / 2;
      alphas.insert({value - 0.5, value, value + 0.5});
    }
    for (const double alpha : alphas) {
      const Found found = find(balls, alpha);
      if (found.ground.triangulation->dimension < 3) break;
      const auto expected = testing::rational_cavities(balls, oracle, alpha, false, true);
      const auto voids =
          std::count_if(found.cavities.cavities.begin(), found.cavities.cavities.end(),
                        [](const Cavity& cavity) { return cavity.is_void(); });
      ASSERT_EQ(voids, expected.betti[2]) << "round " << round << ", alpha " << alpha;
      ASSERT_EQ(found.cavities.voids, voids);
      ++steps;
      with_voids += voids > 0;
    }
  }
  EXPECT_GT(steps, 400u);
  EXPECT_GT(with_voids, 50u);
}

TEST(Cavities, AreNoneBelowDimension3) {
  BallSet plane;
  for (int n = 0; n < 5; ++n) testing::add_ball(plane, n * n, n, 0, 2);
  const auto balls = std::make_shared<const BallSet>(plane);
  for (const BallSet& set : {plane, BallSet{}}) {
    const CavityGround ground =
        make_cavity_ground(std::make_shared<const BallSet>(set),
                           std::make_shared<const Triangulation>(make_triangulation(set, 1)));
    EXPECT_EQ(find_cavities(ground, {}), Cavities());
  }
}

// Each cavity as the set of its tetrahedra's balls.
std::set<std::set<testing::Simplex>> tetrahedra_of(const Found& found,
                                                   const std::vector<BallIndex>& name) {
  std::set<std::set<testing::Simplex>> sets;
  for (const Cavity& cavity : found.cavities.cavities) {
    std::set<testing::Simplex> set;
    for (const std::uint32_t t : cavity.tetrahedra) {
      testing::Simplex simplex = named(found.ground.triangulation->tetrahedra[t]);
      for (BallIndex& v : simplex) v = name[v];
      std::sort(simplex.begin(), simplex.end());
      set.insert(simplex);
    }
    sets.insert(std::move(set));
  }
  return sets;
}

TEST(Cavities, DoNotDependOnTheOrderOfBalls) {
  Random random(102);
  for (int round = 0; round < 20; ++round) {
    const BallSet balls = round % 2 ? testing::random_balls(random, 300, 60, 4, 9)
                                    : testing::large_hard_sets(random, 200)[round].balls;
    std::vector<BallIndex> order(balls.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<BallIndex> same = order;
    std::shuffle(order.begin(), order.end(), random);
    const Found before = find(balls, 0), after = find(testing::permuted(balls, order), 0);
    if (before.ground.triangulation->dimension < 3) continue;
    EXPECT_EQ(before.cavities.simplices, after.cavities.simplices);
    if (before.ground.triangulation->vertices.size() < balls.size()) continue;  // equal balls
    EXPECT_EQ(tetrahedra_of(before, same), tetrahedra_of(after, order));
  }
}

// Sets without tied powers, so that the perturbation decides nothing.
TEST(Cavities, TurnWithTheBalls) {
  Random random(103);
  for (int round = 0; round < 10; ++round) {
    const BallSet balls = testing::random_balls(random, 300, 6000, 400, 900);
    std::vector<BallIndex> same(balls.size());
    std::iota(same.begin(), same.end(), 0u);
    const Found before = find(balls, 0);
    ASSERT_FALSE(before.cavities.cavities.empty());
    BallSet turned = balls, mirrored = balls;
    for (LatticePoint& p : turned.centres) p = {p.y, p.z, p.x};
    for (LatticePoint& p : mirrored.centres) p = {-p.x, p.z, p.y};
    EXPECT_EQ(tetrahedra_of(find(turned, 0), same), tetrahedra_of(before, same));
    EXPECT_EQ(tetrahedra_of(find(mirrored, 0), same), tetrahedra_of(before, same));
  }
}

TEST(Cavities, AreTheSameForAnyNumberOfThreads) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz", 1.4);
  const auto with = [&](int threads) {
    return tbb::task_arena(threads).execute([&] { return find(*balls, 0).cavities; });
  };
  const Cavities alone = with(1);
  EXPECT_GT(alone.cavities.size(), 50u);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(with(threads), alone);
}

}  // namespace
}  // namespace alphascope
