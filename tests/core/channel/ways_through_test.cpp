// SPDX-License-Identifier: GPL-3.0-or-later
// Tests ways through tubes with known bottlenecks: one in each tube and none elsewhere.
#include "core/channel/ways_through.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "core/clearance/clearance.hpp"
#include "core/geometry/alpha.hpp"
#include "tests/core/cavity/gramicidin.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/core/cavity/same_line.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::add_ring;
using testing::add_tube;
using testing::no_balls;

WayPart all_of(const BallSet& balls) {
  WayPart part(balls.size());
  std::iota(part.begin(), part.end(), BallIndex{0});
  return part;
}

void move_last(BallSet& balls, std::size_t from, int x, int y) {
  for (std::size_t n = from; n < balls.size(); ++n) {
    balls.centres[n].x += x;
    balls.centres[n].y += y;
  }
}

BallSet narrow_tube() {
  BallSet balls = no_balls();
  add_tube(balls, -14, 14);
  add_ring(balls, 12, 4.5, 6, 2);
  return balls;
}

TEST(WaysThrough, OfATubeIsTheTube) {
  const BallSet balls = narrow_tube();
  const WaysThrough found = find_ways_through(balls, {all_of(balls)});
  ASSERT_EQ(found.ways.size(), 1u);
  const WayThrough& way = found.ways[0];
  EXPECT_NEAR(way.channel.widest_angstrom, 2.5, 0.0015);
  EXPECT_LT(length(way.channel.narrowest().position_angstrom - RealPoint{0, 0, 6}), 0.05);
  EXPECT_NEAR(std::fabs(way.axis.z), 1, 1e-3);
  EXPECT_NEAR(way.cover.whole_angstrom, 28, 0.1);
  EXPECT_NEAR(way.part_angstrom, 28, 0.1);
  EXPECT_GT(way.cover.share(), 0.95);
  const Clearance clearance(balls);
  for (const ChannelSample& sample : way.channel.samples) {
    EXPECT_NEAR(sample.radius_angstrom, clearance.at(sample.position_angstrom), 1e-7);
    EXPECT_GE(sample.radius_angstrom, way.channel.narrowest().radius_angstrom);
    EXPECT_GE(sample.radius_angstrom, way.channel.widest_angstrom);
  }
  EXPECT_FALSE(way.channel.touching.empty());
  EXPECT_GT(way.lining.size(), 12u);
}

TEST(WaysThrough, ACupHasNone) {
  BallSet balls = narrow_tube();
  add_ball(balls, 0, 0, -14000, 2200);
  add_ring(balls, 12, 3, -14, 2.2);
  EXPECT_TRUE(find_ways_through(balls, {all_of(balls)}).ways.empty());
}

// Like a trimeric porin: a pore in each chain and none on the axis.
TEST(WaysThrough, OfThreeTubesAreOneInEach) {
  BallSet balls = no_balls();
  std::vector<WayPart> parts(1);
  for (int n = 0; n < 3; ++n) {
    const std::size_t from = balls.size();
    add_tube(balls, -14, 14);
    add_ring(balls, 12, 4.5 - 0.1 * n, n, 2);
    const double angle = 2 * std::numbers::pi * n / 3, away = 9300;
    move_last(balls, from, static_cast<int>(away * std::cos(angle)),
              static_cast<int>(away * std::sin(angle)));
    WayPart& part = parts.emplace_back();
    for (std::size_t i = from; i < balls.size(); ++i) part.push_back(static_cast<BallIndex>(i));
  }
  // Fills the space that would be a way between the tubes.
  for (int z = -14; z <= 14; ++z) {
    add_ball(balls, 0, 0, 1000 * z, 2300);
    add_ring(balls, 6, 2, z, 2);
  }
  parts[0] = all_of(balls);
  const WaysThrough found = find_ways_through(balls, parts);
  ASSERT_GE(found.ways.size(), 3u);
  std::set<std::size_t> of;
  for (std::size_t n = 0; n < 3; ++n) {
    const WayThrough& way = found.ways[n];
    EXPECT_NEAR(way.channel.widest_angstrom, 2.5 - 0.1 * static_cast<double>(n), 0.002) << n;
    const RealPoint& p = way.channel.narrowest().position_angstrom;
    EXPECT_NEAR(std::hypot(p.x, p.y), 9.3, 0.1) << n;
    EXPECT_NEAR(p.z, static_cast<double>(n), 0.1) << n;
    // Its lining belongs to one tube.
    std::set<std::size_t> tubes;
    for (const BallIndex ball : way.lining) {
      for (std::size_t part = 1; part < parts.size(); ++part) {
        if (std::binary_search(parts[part].begin(), parts[part].end(), ball)) tubes.insert(part);
      }
    }
    EXPECT_EQ(tubes.size(), 1u) << n;
    of.insert(*tubes.begin());
  }
  EXPECT_EQ(of.size(), 3u);
  for (std::size_t n = 3; n < found.ways.size(); ++n) {
    EXPECT_LT(found.ways[n].channel.widest_angstrom, 1) << n;
  }
}

// Corners of its power diagram are farther apart than a third of its length.
TEST(WaysThrough, OfAShortWideRingIsTheRing) {
  BallSet balls = no_balls();
  for (int z = -3; z <= 3; ++z) add_ring(balls, 60, 16 + 0.3 * z * z, z, 2);
  const WaysThrough found = find_ways_through(balls, {all_of(balls)});
  ASSERT_EQ(found.ways.size(), 1u);
  EXPECT_NEAR(found.ways[0].channel.widest_angstrom, 14, 0.05);
  EXPECT_NEAR(std::fabs(found.ways[0].axis.z), 1, 1e-3);
}

// A trough is open on one side over its whole length. No ring surrounds a line along it.
TEST(WaysThrough, AGrooveIsNone) {
  BallSet balls = no_balls();
  for (int z = -14; z <= 14; ++z) {
    for (int n = 12; n <= 24; ++n) {
      const double angle = 2 * std::numbers::pi * n / 24;
      add_ball(balls, static_cast<int>(6000 * std::cos(angle)),
               static_cast<int>(6000 * std::sin(angle)), 1000 * z, 2000);
    }
    for (int y = 1; y <= 9; ++y) {
      for (const int side : {-1, 1})
        add_ball(balls, side * (6000 + 150 * y), 1000 * y, 1000 * z, 2000);
    }
  }
  EXPECT_TRUE(find_ways_through(balls, {all_of(balls)}).ways.empty());
  // A bridge over it makes a ring.
  for (int x = -6; x <= 6; ++x) add_ball(balls, 1000 * x, 6000, 0, 2000);
  const WaysThrough found = find_ways_through(balls, {all_of(balls)});
  ASSERT_EQ(found.ways.size(), 1u);
  EXPECT_NEAR(found.ways[0].channel.narrowest().position_angstrom.z, 0, 0.2);
  EXPECT_NEAR(found.ways[0].channel.widest_angstrom, 4, 0.15);
}

TEST(WaysThrough, AreTheSameForEveryOrderOfBallsAndNumberOfThreads) {
  const BallSet balls = narrow_tube();
  const WaysThrough reference = find_ways_through(balls, {all_of(balls)});
  ASSERT_EQ(reference.ways.size(), 1u);
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), 0u);
  testing::Random random(5);
  std::shuffle(order.begin(), order.end(), random);
  for (const int threads : {1, 2}) {
    WaysThrough other;
    tbb::task_arena(threads).execute(
        [&] { other = find_ways_through(testing::permuted(balls, order), {all_of(balls)}); });
    ASSERT_EQ(other.ways.size(), 1u);
    const Channel &a = other.ways[0].channel, &b = reference.ways[0].channel;
    testing::expect_same_line(a, b);
    EXPECT_EQ(testing::unpermuted(a.touching, order), b.touching);
  }
}

TEST(WaysThrough, OfGramicidinIsThatOfHole) {
  BallSet balls = no_balls();
  for (const testing::GramicidinAtom& atom : testing::kGramicidin) {
    add_ball(balls, atom.x, atom.y, atom.z,
             atom.element == 'C'   ? 1850
             : atom.element == 'O' ? 1650
                                   : 1750);
  }
  const WaysThrough found = find_ways_through(balls, {all_of(balls)});
  ASSERT_FALSE(found.ways.empty());
  const WayThrough& way = found.ways[0];
  EXPECT_NEAR(way.channel.widest_angstrom, testing::kHoleBottleneck, 0.02);
  EXPECT_GT(way.cover.share(), 0.95);
  EXPECT_NEAR(std::fabs(way.axis.y), 1, 0.01);
}

TEST(WaysThrough, FewOrFlatBallsHaveNone) {
  EXPECT_THROW(find_ways_through(no_balls(), {{}}), std::invalid_argument);
  BallSet balls = no_balls();
  add_ball(balls, 0, 0, 0, 1000);
  EXPECT_TRUE(find_ways_through(balls, {{0}}).ways.empty());
  EXPECT_THROW(find_ways_through(balls, {{0}, {}}), std::invalid_argument);
  add_ball(balls, 0, 0, 3000, 1000);
  EXPECT_TRUE(find_ways_through(balls, {{0, 1}}).ways.empty());
}

TEST(WaysThrough, CanBeCancelledAndReport) {
  const BallSet balls = narrow_tube();
  RunContext context;
  int reports = 0;
  context.progress = [&](std::string_view stage, double) { reports += stage == kWaysStage; };
  find_ways_through(balls, {all_of(balls)}, context);
  EXPECT_GT(reports, 0);
  context.progress = [&](std::string_view, double) { context.cancel.cancel(); };
  EXPECT_THROW(find_ways_through(balls, {all_of(balls)}, context), Cancelled);
}

TEST(WaysThrough, TheCoverOfAChannelIsItsPartOfTheMolecule) {
  const BallSet balls = narrow_tube();
  Channel channel;
  channel.samples = {{{0, 0, -7}, 4, 0}, {{0, 0, 20}, 4, 27}};
  const WayCover cover = cover_of(balls, channel);
  EXPECT_NEAR(cover.covered_angstrom, 21, 1e-6);
  EXPECT_NEAR(cover.whole_angstrom, 28, 1e-6);
  EXPECT_TRUE(cover.is_whole());
  channel.samples.front().position_angstrom.z = -6;
  EXPECT_FALSE(cover_of(balls, channel).is_whole());
}

}  // namespace
}  // namespace alphascope
