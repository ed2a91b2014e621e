// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which cavities correspond at two solvent radii. Compares with shares in rationals, and with
// sets where cavities split and merge.
#include "core/cavity_identity/cavity_identity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/cavity/rational_location.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::Random;

constexpr std::uint32_t kNone = CavityMatch::kNone;

std::shared_ptr<const CavityTable> table_of(const BallSet& balls, double alpha = 0,
                                            double solvent = 0) {
  const auto shared = std::make_shared<const BallSet>(balls);
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      shared, std::make_shared<const Triangulation>(make_triangulation(balls, 1))));
  return std::make_shared<const CavityTable>(make_cavity_table(ground, {alpha, solvent}));
}

BallSet grown(BallSet balls, int by) {
  for (std::int32_t& radius : balls.radii) radius += by;
  return balls;
}

// Returns six times the volume that two cavities share, by the pair of their numbers {earlier,
// later}.
std::map<std::pair<std::uint32_t, std::uint32_t>, mpq_class> rational_shares(
    const CavityTable& earlier, const CavityTable& later) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, mpq_class> shares;
  const BallSet &before = *earlier.ground->balls, &now = *later.ground->balls;
  for (std::uint32_t c = 0; c < later.found.cavities.size(); ++c) {
    for (const std::uint32_t t : later.found.cavities[c].tetrahedra) {
      const auto& corners = later.ground->triangulation->tetrahedra[t];
      LatticePlace centroid{0, 0, 0, 4};
      for (const BallIndex v : corners) {
        centroid.x += now.centres[v].x;
        centroid.y += now.centres[v].y;
        centroid.z += now.centres[v].z;
      }
      const auto at = testing::tetrahedra_at(before, *earlier.ground->triangulation, centroid);
      if (at.empty()) continue;
      const std::uint32_t from = earlier.found.cavity_of_tetrahedron[at[0]];
      if (from == Cavities::kNone) continue;
      const mpq_class volume = testing::six_volumes(testing::corners_of(now, corners));
      shares[{from, c}] += abs(volume);
    }
  }
  return shares;
}

CavityMatch rational_match(const CavityTable& earlier, const CavityTable& later) {
  // The centres of a cavity's deepest sink, where the later set has them.
  const auto sink = [&](const CavityTable& table, std::uint32_t c) {
    std::vector<LatticePoint> centres;
    for (const BallIndex v :
         table.ground->triangulation->tetrahedra[table.found.cavities[c].deepest_sink]) {
      centres.push_back(later.ground->balls->centres[v]);
    }
    std::sort(centres.begin(), centres.end());
    return centres;
  };
  CavityMatch match;
  match.came_from.assign(later.found.cavities.size(), kNone);
  match.goes_to.assign(earlier.found.cavities.size(), kNone);
  const auto shares = rational_shares(earlier, later);
  for (const auto& share : shares) {
    const auto [a, b] = share.first;
    const mpq_class& volume = share.second;
    std::uint32_t &from = match.came_from[b], &to = match.goes_to[a];
    const auto beats = [&](const mpq_class& other, const auto& mine, const auto& its) {
      return volume > other || (volume == other && mine < its);
    };
    if (from == kNone || beats(shares.at({from, b}), sink(earlier, a), sink(earlier, from))) {
      from = a;
    }
    if (to == kNone || beats(shares.at({a, to}), sink(later, b), sink(later, to))) to = b;
  }
  return match;
}

TEST(CavityIdentity, SharesAreThoseOfTheDefinitionInRationals) {
  Random random(31);
  std::size_t same = 0, splits = 0, merges = 0, elsewhere = 0;
  const int rounds = testing::unless_sanitized(25, 8);
  for (int round = 0; round < rounds; ++round) {
    BallSet balls = testing::random_balls(random, 25, 9, 2, 4);
    for (const int by : {1, -1, 2}) {
      const auto a = table_of(by < 0 ? grown(balls, -by) : balls);
      const auto b = table_of(by < 0 ? balls : grown(balls, by));
      const CavityMatch match = match_cavities(*a, *b);
      ASSERT_EQ(match, rational_match(*a, *b)) << "round " << round;
      for (std::uint32_t c = 0; c < match.came_from.size(); ++c) {
        same += match.is_same(c);
        merges += match.sources(c).size() > 1;
      }
      for (std::uint32_t c = 0; c < match.goes_to.size(); ++c) splits += match.parts(c).size() > 1;
      elsewhere += a->ground->triangulation->tetrahedra != b->ground->triangulation->tetrahedra;
    }
  }
  const auto enough = static_cast<std::size_t>(rounds);
  EXPECT_GT(same, 2 * enough);
  EXPECT_GT(splits, enough / 5);
  EXPECT_GT(merges, enough / 8);
  EXPECT_GT(elsewhere, 2 * enough);
}

// A box with an inner wall that has a hole: two chambers, which are one while the hole is open.
// Balls are 4 apart. With radius 3 they close the box, with radius 4 the hole.
BallSet two_chambers(int length, int wall) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (int x = 0; x <= length; ++x) {
    for (int y = 0; y <= 4; ++y) {
      for (int z = 0; z <= 4; ++z) {
        const bool shell = x == 0 || x == length || y == 0 || y == 4 || z == 0 || z == 4;
        const bool hole = y == 2 && z == 2;
        if (shell || (x == wall && !hole)) testing::add_ball(balls, 4 * x, 4 * y, 4 * z, 3);
      }
    }
  }
  return balls;
}

TEST(CavityIdentity, AVoidThatSplitsGoesOnInItsLargerPart) {
  const BallSet balls = two_chambers(10, 4);
  const auto open = table_of(balls), closed = table_of(grown(balls, 2));
  ASSERT_EQ(open->voids, 1u);
  ASSERT_EQ(closed->voids, 2u);
  ASSERT_EQ(closed->pockets, 0u);
  const CavityMatch split = match_cavities(*open, *closed);
  EXPECT_EQ(split.parts(open->order[0]), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(split.goes_to[open->order[0]], closed->order[0]);
  EXPECT_TRUE(split.is_same(closed->order[0]));
  EXPECT_FALSE(split.is_same(closed->order[1]));
  const CavityMatch merge = match_cavities(*closed, *open);
  EXPECT_EQ(merge.sources(open->order[0]), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(merge.came_from[open->order[0]], closed->order[0]);
  EXPECT_TRUE(merge.is_same(open->order[0]));
}

// The chambers have equal volumes. The one of small x has the first centres.
TEST(CavityIdentity, OfPartsOfOneSizeTheOneOfTheFirstSinkGoesOn) {
  BallSet balls = two_chambers(8, 4);
  for (int turn = 0; turn < 2; ++turn) {
    const auto open = table_of(balls), closed = table_of(grown(balls, 2));
    ASSERT_EQ(closed->voids, 2u);
    const CavityMatch split = match_cavities(*open, *closed);
    const std::uint32_t goes_on = split.goes_to[open->order[0]];
    const auto& sink =
        closed->ground->triangulation->tetrahedra[closed->found.cavities[goes_on].deepest_sink];
    for (const BallIndex v : sink) EXPECT_LE(balls.centres[v].x, 16);
    const CavityMatch merge = match_cavities(*closed, *open);
    EXPECT_EQ(merge.came_from[open->order[0]], goes_on);
    const CavityMatch by_atoms =
        match_regions(regions_of(*closed), regions_of(*open), *open->ground->balls);
    EXPECT_EQ(by_atoms.came_from.size(), 1u);
    if (!testing::kAddressSanitizer) {
      EXPECT_EQ(split, rational_match(*open, *closed));
    }
    std::reverse(balls.centres.begin(), balls.centres.end());
  }
}

TEST(CavityIdentity, AlphaMovesGoByTheDeepestSink) {
  const BallSet balls = two_chambers(10, 4);
  const auto open = table_of(balls);
  const auto closed = std::make_shared<const CavityTable>(make_cavity_table(open->ground, {16, 0}));
  ASSERT_EQ(closed->voids, 2u);
  const CavityMatch split = match_cavities(*open, *closed);
  EXPECT_EQ(split.parts(0).size(), 2u);
  const std::uint32_t on = split.goes_to[0];
  EXPECT_EQ(closed->found.cavities[on].deepest_sink, open->found.cavities[0].deepest_sink);
  const CavityMatch merge = match_cavities(*closed, *open);
  EXPECT_EQ(merge.came_from[0], on);
  EXPECT_EQ(merge.sources(0).size(), 2u);
}

TEST(CavityIdentity, TheOrderOfTheBallsDoesNotMatter) {
  Random random(33);
  const BallSet balls = *testing::sample_balls("1crn.pdb", 0.8);
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  const auto links = [&](const std::vector<BallIndex>* names) {
    const BallSet set = names ? testing::permuted(balls, *names) : balls;
    const auto a = table_of(set), b = table_of(grown(set, 200));
    const CavityMatch match = match_cavities(*a, *b);
    const auto sink = [&](const CavityTable& table, std::uint32_t c) {
      std::vector<BallIndex> corners;
      if (c == kNone) return corners;
      for (const BallIndex v :
           table.ground->triangulation->tetrahedra[table.found.cavities[c].deepest_sink]) {
        corners.push_back(names ? (*names)[v] : v);
      }
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    std::map<std::vector<BallIndex>, std::vector<BallIndex>> from;
    for (std::uint32_t c = 0; c < match.came_from.size(); ++c) {
      from[sink(*b, c)] = sink(*a, match.came_from[c]);
    }
    return from;
  };
  const auto plain = links(nullptr);
  EXPECT_EQ(plain, links(&order));
  EXPECT_GT(plain.size(), 3u);
}

TEST(CavityIdentity, RegionsOfTheSameTrianglesGiveTheSameMatch) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz");
  const auto at = [&](double s) { return table_of(with_solvent(*balls, s), 0, s); };
  const auto a = at(1.4), b = at(1.4), c = at(1.5);
  const CavityMatch whole = match_cavities(*a, *b);
  const CavityMatch regions = match_regions(regions_of(*a), regions_of(*b), *b->ground->balls);
  EXPECT_EQ(whole, regions);
  for (std::uint32_t n = 0; n < whole.came_from.size(); ++n) EXPECT_EQ(whole.came_from[n], n);
  // At another radius, most cavities still share tetrahedra with their former selves. Their largest
  // share may be with another cavity, though.
  const CavityMatch grow = match_cavities(*a, *c);
  const CavityMatch by_atoms = match_regions(regions_of(*a), regions_of(*c), *c->ground->balls);
  std::size_t equal = 0;
  for (std::uint32_t n = 0; n < grow.came_from.size(); ++n) {
    equal += grow.came_from[n] == by_atoms.came_from[n];
  }
  EXPECT_GE(equal + 2, grow.came_from.size());
}

// A solvent radius of four decimals refines the lattice. Equal balls on a coarser lattice must give
// the same match.
TEST(CavityIdentity, LatticesMayDiffer) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz");
  BallSet finer = *balls;
  ++finer.lattice.digits;
  for (LatticePoint& p : finer.centres) p = {10 * p.x, 10 * p.y, 10 * p.z};
  for (std::int32_t& radius : finer.radii) radius *= 10;
  const auto coarse = table_of(with_solvent(*balls, 1.4), 0, 1.4),
             fine = table_of(with_solvent(finer, 1.4), 0, 1.4),
             other = table_of(with_solvent(*balls, 1.2005), 0, 1.2005);
  ASSERT_NE(coarse->ground->balls->lattice.digits, other->ground->balls->lattice.digits);
  ASSERT_EQ(fine->ground->balls->lattice.digits, other->ground->balls->lattice.digits);
  ASSERT_EQ(coarse->found.cavities.size(), fine->found.cavities.size());
  const CavityMatch to = match_cavities(*coarse, *other), back = match_cavities(*other, *coarse);
  EXPECT_EQ(to, match_cavities(*fine, *other));
  EXPECT_EQ(back, match_cavities(*other, *fine));
  std::size_t same = 0;
  for (std::uint32_t c = 0; c < to.came_from.size(); ++c) same += to.is_same(c);
  EXPECT_GT(same, 40u);
}

TEST(CavityIdentity, OtherAtomsAreRefused) {
  const auto a = table_of(two_chambers(10, 4)), b = table_of(two_chambers(8, 4));
  EXPECT_THROW(match_cavities(*a, *b), std::invalid_argument);
  EXPECT_TRUE(match_cavities(*a, *a).is_same(0));
  const auto none = table_of(BallSet{});
  EXPECT_TRUE(match_cavities(*none, *none).came_from.empty());
}

TEST(CavityNumbers, StayWhileTheSolventRadiusSlidesAndComeBack) {
  const BallSet balls = two_chambers(10, 4);
  const auto open = table_of(balls), closed = table_of(grown(balls, 2));
  const CavityNumbers one = first_numbers(open);
  EXPECT_EQ(one.of, (std::vector<std::uint32_t>{0}));
  const CavityNumbers two = next_numbers(one, closed);
  EXPECT_EQ(two.of[closed->order[0]], 0u);
  EXPECT_EQ(two.of[closed->order[1]], 1u);
  const CavityNumbers again = next_numbers(next_numbers(two, open), closed);
  EXPECT_EQ(again.of, two.of);
  EXPECT_EQ(again.used, 2u);
  EXPECT_EQ(again.cavity(1), closed->order[1]);
  EXPECT_EQ(again.cavity(7), kNone);
  // The start has two chambers. The number of the smaller one waits while it is part of the larger
  // one.
  const CavityNumbers both = first_numbers(closed);
  const CavityNumbers joined = next_numbers(both, open);
  EXPECT_EQ(joined.of, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(next_numbers(joined, closed).of, both.of);
}

TEST(CavityNumbers, ANumberLeadsToWhatItsCavityHasMergedInto) {
  const BallSet balls = two_chambers(10, 4);
  const auto open = table_of(balls), closed = table_of(grown(balls, 2)),
             filled = table_of(grown(balls, 6));
  ASSERT_EQ(filled->size(), 0u);
  const CavityNumbers both = first_numbers(closed);
  EXPECT_EQ(both.cavity_or_heir(1), closed->order[1]);
  EXPECT_EQ(both.cavity_or_heir(7), kNone);
  const CavityNumbers joined = next_numbers(both, open);
  EXPECT_EQ(joined.cavity(1), kNone);
  EXPECT_EQ(joined.cavity_or_heir(1), open->order[0]);
  EXPECT_EQ(joined.cavity_or_heir(0), open->order[0]);
  const CavityNumbers parted = next_numbers(joined, closed);
  EXPECT_EQ(parted.cavity_or_heir(1), closed->order[1]) << "it is one of its own again";
  EXPECT_TRUE(parted.merged_into.empty());
  // The cavity into which it merged may vanish and come back.
  const CavityNumbers gone = next_numbers(joined, filled);
  EXPECT_EQ(gone.cavity_or_heir(1), kNone);
  EXPECT_EQ(next_numbers(gone, open).cavity_or_heir(1), open->order[0]);
}

TEST(CavityNumbers, AreNeverGivenTwice) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz");
  CavityNumbers numbers;
  for (const double s : {1.4, 1.0, 1.6, 0.6, 1.4, 1.2}) {
    const auto table = table_of(with_solvent(*balls, s), 0, s);
    numbers = numbers.table ? next_numbers(numbers, table) : first_numbers(table);
    std::vector<std::uint32_t> sorted = numbers.of;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    ASSERT_FALSE(sorted.empty());
    EXPECT_LT(sorted.back(), numbers.used);
  }
}

}  // namespace
}  // namespace alphascope
