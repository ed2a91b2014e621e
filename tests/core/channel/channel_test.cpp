// SPDX-License-Identifier: GPL-3.0-or-later
// Tests channels with known bottlenecks: built of rings, found by flooding a fine grid, or
// published.
#include "core/channel/channel.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <thread>

#include "core/clearance/clearance.hpp"
#include "core/geometry/alpha.hpp"
#include "tests/core/cavity/flooded_grid.hpp"
#include "tests/core/cavity/gramicidin.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/core/cavity/same_line.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::add_ring;
using testing::add_tube;
using testing::expect_same_line;
using testing::no_balls;
using testing::Random;
using testing::random_int;

// Properties of every channel.
void expect_sound(const BallSet& balls, const Channel& channel) {
  const Clearance clearance(balls);
  ASSERT_FALSE(channel.samples.empty());
  const ChannelSample& narrowest = channel.narrowest();
  EXPECT_GE(narrowest.radius_angstrom, channel.widest_angstrom - 1e-9);
  EXPECT_LE(narrowest.radius_angstrom, channel.widest_angstrom + channel.step_angstrom + 1e-6);
  double along = 0;
  std::size_t narrower = 0;
  for (std::size_t n = 0; n < channel.samples.size(); ++n) {
    const ChannelSample& sample = channel.samples[n];
    EXPECT_NEAR(sample.radius_angstrom, clearance.at(sample.position_angstrom), 1e-7);
    narrower += sample.radius_angstrom < narrowest.radius_angstrom - 1e-3;
    if (n > 0) {
      const double step =
          length(sample.position_angstrom - channel.samples[n - 1].position_angstrom);
      EXPECT_LE(step, 0.1 + 1e-9);
      along += step;
    }
    EXPECT_NEAR(sample.along_angstrom, along, 1e-6);
  }
  EXPECT_EQ(narrower, 0u);
  EXPECT_NEAR(channel.length_angstrom, along, 1e-6);
  std::vector<Surface> surfaces;
  clearance.collect(narrowest.position_angstrom, narrowest.radius_angstrom + 0.01, surfaces);
  std::vector<BallIndex> touching;
  for (const Surface& surface : surfaces) touching.push_back(surface.ball);
  std::sort(touching.begin(), touching.end());
  EXPECT_EQ(channel.touching, touching);
  if (channel.limit == ChannelLimit::passage && channel.step_angstrom <= 0.001) {
    EXPECT_GE(touching.size(), 2u);
  }
}

TEST(Channel, OfATubeIsItsNarrowRing) {
  BallSet balls = no_balls();
  add_tube(balls, -10, 10);
  const auto first_of_ring = static_cast<BallIndex>(balls.size());
  add_ring(balls, 12, 4.5, 2, 2);
  const Channel channel = find_channel(balls, ChannelEnds::through({0.3, -0.2, -5}, {0, 0, 1}));
  expect_sound(balls, channel);
  EXPECT_EQ(channel.limit, ChannelLimit::passage);
  EXPECT_NEAR(channel.widest_angstrom, 2.5, 0.0015);  // coordinates are rounded to 0.001
  EXPECT_LT(length(channel.narrowest().position_angstrom - RealPoint{0, 0, 2}), 0.01);
  ASSERT_FALSE(channel.touching.empty());
  EXPECT_GE(channel.touching.front(), first_of_ring);
  // The channel leads out at both ends, along the axis.
  EXPECT_LT(channel.samples.front().position_angstrom.z, -10);
  EXPECT_GT(channel.samples.back().position_angstrom.z, 10);
  for (const ChannelSample& sample : channel.samples) {
    const RealPoint& p = sample.position_angstrom;
    if (std::fabs(p.z) < 10) {
      EXPECT_LT(std::hypot(p.x, p.y), 0.02) << p.z;
    }
  }
  EXPECT_LE(channel.triangulations, 10);
}

// With an end radius of less than 1.5 times the bottleneck, the line would end close to the
// bottleneck. So the end radius is then raised.
TEST(Channel, GoesOnUntilItIsWiderThanItsBottleneck) {
  BallSet balls = no_balls();
  add_tube(balls, -10, 10);
  add_ring(balls, 12, 4.5, 2, 2);
  ChannelEnds ends = ChannelEnds::through({0, 0, -5}, {0, 0, 1});
  for (const double wanted : {0.5, 2.5, 3.7, 4.5, 7.0}) {
    ends.end_radius_angstrom = wanted;
    const Channel channel = find_channel(balls, ends);
    expect_sound(balls, channel);
    const double radius = std::max(wanted, 1.5 * channel.widest_angstrom);
    EXPECT_DOUBLE_EQ(channel.end_radius_angstrom, radius) << wanted;
    for (const ChannelSample* end : {&channel.samples.front(), &channel.samples.back()}) {
      // The end is at most a step behind the place where it gets that wide.
      EXPECT_GE(end->radius_angstrom, radius - 1e-6) << wanted;
      if (radius > 4) {
        EXPECT_LE(end->radius_angstrom, radius + 0.1) << wanted;
      }
    }
  }
}

// The big balls of one end leave a hole of 1.0 Å, the small balls of the other one of 1.2 Å. By
// power distance, (hole + r)² - r², the first hole is the wider one: 11 against 3.84 Å².
TEST(Channel, IsOrderedByClearanceNotByPowerDistance) {
  BallSet balls = no_balls();
  for (int z = 0; z <= 12; ++z) add_ring(balls, 40, 8, z, 2);
  add_ring(balls, 12, 6, 0, 5);
  add_ring(balls, 12, 2.2, 12, 1);
  for (const double distance : {3.5, 4.8, 6.0}) add_ring(balls, 40, distance, 12, 1);
  const Channel out = find_channel(balls, ChannelEnds::out({0, 0, 7}));
  expect_sound(balls, out);
  EXPECT_NEAR(out.widest_angstrom, 1.2, 0.0015);
  EXPECT_NEAR(out.narrowest().position_angstrom.z, 12, 0.05);
  const Channel down = find_channel(balls, ChannelEnds::out_along({0, 0, 7}, {0, 0, -1}));
  EXPECT_NEAR(down.widest_angstrom, 1.0, 0.0015);
}

TEST(Channel, KeepsToItsSideOfThePlane) {
  BallSet balls = no_balls();
  add_tube(balls, -12, 12);
  add_ring(balls, 12, 4, 8, 2.2);   // 1.8 Å wide, at the upper end
  add_ring(balls, 12, 5, -8, 2.2);  // 2.8 Å wide, at the lower end
  const RealPoint middle{0, 0, 0};
  EXPECT_NEAR(find_channel(balls, ChannelEnds::out(middle)).widest_angstrom, 2.8, 0.0015);
  EXPECT_NEAR(find_channel(balls, ChannelEnds::out_along(middle, {0, 0, -2})).widest_angstrom, 2.8,
              0.0015);
  EXPECT_NEAR(find_channel(balls, ChannelEnds::out_along(middle, {0, 0, 0.5})).widest_angstrom, 1.8,
              0.0015);
  const Channel both = find_channel(balls, ChannelEnds::through(middle, {0, 0, 1}));
  expect_sound(balls, both);
  EXPECT_NEAR(both.widest_angstrom, 1.8, 0.0015);
  const Channel between = find_channel(balls, ChannelEnds::between(middle, {0, 0, 25}));
  expect_sound(balls, between);
  EXPECT_NEAR(between.widest_angstrom, 2.8, 0.0015);  // the long way round
}

TEST(Channel, OfAClosedTubeIsNegative) {
  BallSet balls = no_balls();
  add_tube(balls, -6, 6);
  for (const double z : {-6.0, 6.0}) {
    add_ball(balls, 0, 0, static_cast<int>(1000 * z), 2000);
    add_ring(balls, 12, 3, z, 1.6);
  }
  const Channel channel = find_channel(balls, ChannelEnds::out({0, 0, 0}));
  EXPECT_FALSE(channel.is_open());
  const testing::FloodedGrid grid(balls, 0.3, 9);
  EXPECT_NEAR(channel.widest_angstrom, grid.widest_out({0, 0, 0}), grid.error());
  expect_sound(balls, channel);
}

TEST(Channel, AGivenPointMayBeTheNarrowestPlace) {
  BallSet balls = no_balls();
  add_tube(balls, -10, 10);
  const Channel channel = find_channel(balls, ChannelEnds::out({3.5, 0, 0}));
  expect_sound(balls, channel);
  EXPECT_EQ(channel.limit, ChannelLimit::end);
  EXPECT_EQ(channel.bottleneck, 0u);
  EXPECT_EQ(channel.narrowest().position_angstrom, (RealPoint{3.5, 0, 0}));
}

// Balls in one plane have no tetrahedra of their own.
TEST(Channel, OfAFlatRing) {
  BallSet balls = no_balls();
  add_ring(balls, 16, 5, 0, 2);
  const Channel channel = find_channel(balls, ChannelEnds::between({0, 0, 4}, {0, 0, -4}));
  expect_sound(balls, channel);
  EXPECT_GE(channel.widest_angstrom, 3 - 0.0015);
  BallSet one = no_balls();
  add_ball(one, 0, 0, 0, 1000);
  const Channel away = find_channel(one, ChannelEnds::out({3, 0, 0}));
  expect_sound(one, away);
  EXPECT_EQ(away.widest_angstrom, 1.999);
  EXPECT_EQ(away.limit, ChannelLimit::end);
}

// Random balls of all sizes, or small balls all around the origin, which is then closed in.
BallSet balls_to_flood(Random& random, bool closed) {
  BallSet balls = no_balls();
  const int count = closed ? 400 : random_int(random, 4, 60);
  for (int i = 0; i < count; ++i) {
    const auto any = [&](int most) { return random_int(random, -most, most); };
    int p[3] = {any(5000), any(5000), any(5000)};
    if (closed) {
      const double size = 4500 / std::hypot(p[0], p[1], p[2]);
      for (int& v : p) v = static_cast<int>(v * size);
    }
    const int radius = closed       ? random_int(random, 1000, 1600)
                       : i % 5 == 0 ? random_int(random, 2000, 3500)
                                    : random_int(random, 600, 1800);
    add_ball(balls, p[0], p[1], p[2], radius);
  }
  return balls;
}

// A walk on the grid is a valid walk, and every walk has one on the grid near it.
TEST(Channel, IsWhatFloodingAGridFinds) {
  Random random(7);
  constexpr double kSpacing = 0.5;
  int closed = 0;
  for (int n = 0; n < 12; ++n) {
    const BallSet balls = balls_to_flood(random, n % 4 == 3);
    const testing::FloodedGrid grid(balls, kSpacing, 9);
    const Clearance clearance(balls);
    // Places of the grid outside all balls.
    std::vector<RealPoint> outside;
    if (n % 4 == 3) outside.push_back({0, 0, 0});
    while (outside.size() < 2) {
      const RealPoint x{random_int(random, -8, 8) * kSpacing, random_int(random, -8, 8) * kSpacing,
                        random_int(random, -8, 8) * kSpacing};
      if (clearance.at(x) > 0.1) outside.push_back(x);
    }
    const RealPoint a = outside[0], b = outside[1];
    const double error = grid.error();
    const Channel out = find_channel(balls, ChannelEnds::out(a));
    expect_sound(balls, out);
    EXPECT_NEAR(out.widest_angstrom, grid.widest_out(a), error) << n;
    const Channel between = find_channel(balls, ChannelEnds::between(a, b));
    expect_sound(balls, between);
    EXPECT_NEAR(between.widest_angstrom, grid.widest_between(a, b), error) << n;
    const Channel up = find_channel(balls, ChannelEnds::out_along(a, {0, 0, 1}));
    expect_sound(balls, up);
    EXPECT_NEAR(up.widest_angstrom, grid.widest_up(a), error) << n;
    EXPECT_LE(up.widest_angstrom, out.widest_angstrom + 1e-9);
    closed += !out.is_open();
  }
  EXPECT_GT(closed, 0);
}

TEST(Channel, IsTheSameForEveryOrderOfBallsAndNumberOfThreads) {
  Random random(11);
  BallSet balls = no_balls();
  for (int n = 0; n < 150; ++n) {
    add_ball(balls, random_int(random, -9000, 9000), random_int(random, -9000, 9000),
             random_int(random, -9000, 9000), random_int(random, 900, 2100));
  }
  // Starts from the widest of some random places.
  const Clearance clearance(balls);
  RealPoint start;
  for (int n = 0; n < 3000; ++n) {
    const RealPoint x{random_int(random, -4000, 4000) / 1000.0,
                      random_int(random, -4000, 4000) / 1000.0,
                      random_int(random, -4000, 4000) / 1000.0};
    if (clearance.at(x) > clearance.at(start)) start = x;
  }
  const ChannelEnds ends = ChannelEnds::through(start, {0.3, -0.4, 0.8});
  const Channel reference = find_channel(balls, ends);
  expect_sound(balls, reference);
  for (const int threads : {1, 2}) {
    Channel other;
    tbb::task_arena(threads).execute([&] { other = find_channel(balls, ends); });
    expect_same_line(other, reference);
    EXPECT_EQ(other.touching, reference.touching);
  }
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  const Channel permuted = find_channel(testing::permuted(balls, order), ends);
  expect_same_line(permuted, reference);
  EXPECT_EQ(testing::unpermuted(permuted.touching, order), reference.touching);
}

// A lattice of 6 digits has no room for the helping balls. So the set is rounded, and the answer
// changes by the rounding only.
TEST(Channel, OfAFineLatticeIsRounded) {
  BallSet balls = no_balls();
  add_tube(balls, -6, 6);
  add_ring(balls, 12, 4.2, 1, 2);
  const ChannelEnds ends = ChannelEnds::through({0, 0, -3}, {0, 0, 1});
  const Channel fine = find_channel(on_finer_lattice(balls, 6), ends);
  EXPECT_NEAR(fine.widest_angstrom, find_channel(balls, ends).widest_angstrom, 0.0011);
  EXPECT_DOUBLE_EQ(fine.step_angstrom, 0.001);
}

// Any set of balls gives a sound answer, or is refused with a reason.
TEST(Channel, OfHardSetsIsSoundOrRefused) {
  Random random(23);
  std::vector<testing::NamedBalls> sets = testing::small_hard_sets(random, 40);
  for (testing::NamedBalls& set :
       testing::large_hard_sets(random, testing::unless_sanitized(120, 40)))
    sets.push_back(std::move(set));
  int answers = 0;
  for (const testing::NamedBalls& set : sets) {
    SCOPED_TRACE(set.name);
    if (set.balls.size() == 0) continue;
    const Lattice& lattice = set.balls.lattice;
    RealPoint centre;
    for (const LatticePoint& p : set.balls.centres) {
      centre = centre +
               (lattice.unit_angstrom() / static_cast<double>(set.balls.size())) * real_point(p);
    }
    const double size = 3 * lattice.unit_angstrom();
    const RealPoint beside = centre + RealPoint{size, 0.4 * size, -size};
    for (const ChannelEnds& ends :
         {ChannelEnds::out(beside), ChannelEnds::out_along(beside, {1, 2, 2}),
          ChannelEnds::between(beside, centre), ChannelEnds::through(centre, {0, 0, 1})}) {
      try {
        const Channel channel = find_channel(set.balls, ends);
        ++answers;
        // Beyond so many digits the set had to be rounded.
        constexpr int kMostDigits = 4;
        if (lattice.digits <= kMostDigits &&
            channel.step_angstrom == std::max(0.001, lattice.unit_angstrom())) {
          expect_sound(set.balls, channel);
        }
      } catch (const std::invalid_argument&) {
      }
    }
  }
  EXPECT_GT(answers, 50);
}

TEST(Channel, SaysWhichBallCoversAnEnd) {
  BallSet balls = no_balls();
  add_ball(balls, 9000, 0, 0, 1000);
  add_ball(balls, 0, 0, 0, 2000);
  try {
    find_channel(balls, ChannelEnds::out({0, 0.5, 0}));
    FAIL();
  } catch (const ChannelEndCovered& covered) {
    EXPECT_EQ(covered.ball, 1u);
    EXPECT_NEAR(covered.depth_angstrom, 1.5, 1e-9);
    EXPECT_STREQ(covered.what(),
                 "the channel's end (0.000, 0.500, 0.000) Å lies in ball 1, 1.500 Å below its "
                 "surface; choose a point outside all balls");
  }
  // A point on the surface is not outside.
  EXPECT_THROW(find_channel(balls, ChannelEnds::out({2, 0, 0})), ChannelEndCovered);
  EXPECT_THROW(find_channel(balls, ChannelEnds::between({5, 0, 0}, {0, 0, 1})), ChannelEndCovered);
}

TEST(Channel, RefusesWhatHasNoAnswer) {
  BallSet balls = no_balls();
  EXPECT_THROW(find_channel(balls, ChannelEnds::out({0, 0, 0})), std::invalid_argument);
  add_ball(balls, 0, 0, 0, 2000);
  add_ball(balls, 9000, 0, 0, 2000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_channel(balls, ChannelEnds::out({nan, 0, 0})), std::invalid_argument);
  EXPECT_THROW(find_channel(balls, ChannelEnds::out({1e30, 0, 0})), std::invalid_argument);
  EXPECT_THROW(find_channel(balls, ChannelEnds::out_along({4, 0, 0}, {0, 0, 0})),
               std::invalid_argument);
  EXPECT_THROW(find_channel(balls, ChannelEnds::out_along({4, 0, 0}, {0, nan, 0})),
               std::invalid_argument);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(find_channel(balls, ChannelEnds::out_along({4, 0, 0}, {0, infinite, 0})),
               std::invalid_argument);
  EXPECT_THROW(find_channel(balls, ChannelEnds::through({4, 0, 0}, {0, 0, 1})),
               std::invalid_argument);
  EXPECT_THROW(find_channel(balls, ChannelEnds::between({4, 0, 0}, {4, 0, 0})),
               std::invalid_argument);
  ChannelEnds no_radius = ChannelEnds::out({4, 0, 0});
  no_radius.end_radius_angstrom = nan;
  EXPECT_THROW(find_channel(balls, no_radius), std::invalid_argument);
}

TEST(Channel, CanBeCancelledAndReports) {
  BallSet balls = no_balls();
  add_tube(balls, -10, 10);
  const auto caller = std::this_thread::get_id();
  RunContext context;
  int reports = 0;
  context.progress = [&](std::string_view, double) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    ++reports;
  };
  find_channel(balls, ChannelEnds::through({0, 0, 0}, {0, 0, 1}), context);
  EXPECT_GT(reports, 0);
  context.progress = [&](std::string_view, double) { context.cancel.cancel(); };
  EXPECT_THROW(find_channel(balls, ChannelEnds::out({0, 0, 0}), context), Cancelled);
}

BallSet gramicidin() {
  BallSet balls = no_balls();
  for (const testing::GramicidinAtom& atom : testing::kGramicidin) {
    add_ball(balls, atom.x, atom.y, atom.z,
             atom.element == 'C'   ? 1850
             : atom.element == 'O' ? 1650
                                   : 1750);
  }
  return balls;
}

// HOLE searches for the widest place in random planes, so its result is slightly below ours.
TEST(Channel, OfGramicidinIsThatOfHole) {
  const BallSet balls = gramicidin();
  const Channel channel = find_channel(balls, ChannelEnds::through({0, 0, 4.2}, {0, 1, 0}));
  expect_sound(balls, channel);
  EXPECT_NEAR(channel.widest_angstrom, testing::kHoleBottleneck, 0.02);
  EXPECT_EQ(channel.touching.size(), 3u);
  double squares = 0;
  for (const testing::PoreRadius& pore : testing::kHoleProfile) {
    const auto after = std::find_if(
        channel.samples.begin(), channel.samples.end(),
        [&](const ChannelSample& sample) { return sample.position_angstrom.y > pore.y; });
    ASSERT_TRUE(after != channel.samples.begin() && after != channel.samples.end());
    const ChannelSample &a = after[-1], &b = *after;
    const double share =
        (pore.y - a.position_angstrom.y) / (b.position_angstrom.y - a.position_angstrom.y);
    const double radius = a.radius_angstrom + share * (b.radius_angstrom - a.radius_angstrom);
    EXPECT_NEAR(radius, pore.radius, 0.1) << pore.y;
    squares += (radius - pore.radius) * (radius - pore.radius);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(std::size(testing::kHoleProfile))), 0.05);
}

}  // namespace
}  // namespace alphascope
