// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bottlenecks of many places at once, and the widest places of cavities.
#include "core/channel/bottlenecks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_shape/cavity_places.hpp"
#include "core/channel/channel.hpp"
#include "core/clearance/clearance.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/cavity/gramicidin.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::add_ring;
using testing::add_tube;
using testing::no_balls;
using testing::Random;
using testing::random_int;

// Each answer must be that of a separate channel search.
void expect_as_channels(const BallSet& balls, const std::vector<RealPoint>& places) {
  const Bottlenecks found = find_bottlenecks(balls, places);
  ASSERT_EQ(found.of.size(), places.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    const Bottleneck& b = found.of[n];
    SCOPED_TRACE(n);
    if (Clearance(balls).at(places[n]) < 0) {
      EXPECT_EQ(b.kind, Bottleneck::Kind::covered);
      continue;
    }
    const Channel channel = find_channel(balls, ChannelEnds::out(places[n]));
    ASSERT_EQ(b.is_open(), channel.is_open());
    if (!b.is_open()) continue;
    EXPECT_GE(channel.widest_angstrom + channel.step_angstrom, b.at_least_angstrom + 1e-9);
    EXPECT_LT(channel.widest_angstrom, b.below_angstrom - 1e-9);
    EXPECT_NEAR(b.below_angstrom - b.at_least_angstrom, kBottleneckStepAngstrom, 1e-9);
    EXPECT_GE(b.radius_angstrom, b.at_least_angstrom);
    EXPECT_LT(b.radius_angstrom, b.below_angstrom);
    if (b.kind == Bottleneck::Kind::passage && channel.limit == ChannelLimit::passage) {
      EXPECT_NEAR(b.radius_angstrom, channel.narrowest().radius_angstrom, 0.0101);
    }
  }
}

TEST(Bottlenecks, OfATubeWithTwoChambers) {
  BallSet balls = no_balls();
  add_tube(balls, -16, 16);
  add_ball(balls, 0, 0, -16000, 2000);  // a floor
  add_ring(balls, 8, 2.5, -16, 2);
  add_ring(balls, 12, 4, 0, 2.2);   // 1.8 Å wide, between the chambers
  add_ring(balls, 12, 5, 12, 2.2);  // 2.8 Å wide, the way out
  const std::vector<RealPoint> places{{0, 0, -8}, {0, 0, 6}, {0, 0, 40}, {6, 0, 0}, {0, 0, 6}};
  const Bottlenecks found = find_bottlenecks(balls, places);
  expect_as_channels(balls, places);
  EXPECT_NEAR(found.of[0].radius_angstrom, 1.8, 0.0015);
  EXPECT_LT(length(found.of[0].place_angstrom - RealPoint{0, 0, 0}), 0.05);
  EXPECT_GE(found.of[0].touching.size(), 3u);
  EXPECT_NEAR(found.of[1].radius_angstrom, 2.8, 0.0015);
  EXPECT_EQ(found.of[2].kind, Bottleneck::Kind::end) << "far outside";
  EXPECT_EQ(found.of[3].kind, Bottleneck::Kind::covered);
  EXPECT_EQ(found.of[4].radius_angstrom, found.of[1].radius_angstrom);
}

TEST(Bottlenecks, AreThoseOfChannelsAmongRandomBalls) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    BallSet balls = no_balls();
    const int largest = seed % 2 == 0 ? 1800 : 3500;
    for (int n = 0; n < 220; ++n) {
      add_ball(balls, random_int(random, -9000, 9000), random_int(random, -9000, 9000),
               random_int(random, -9000, 9000), random_int(random, 900, largest));
    }
    std::vector<RealPoint> places;
    for (int n = 0; n < 12; ++n) {
      places.push_back({random_int(random, -8000, 8000) / 1000.0,
                        random_int(random, -8000, 8000) / 1000.0,
                        random_int(random, -8000, 8000) / 1000.0});
    }
    SCOPED_TRACE(seed);
    expect_as_channels(balls, places);
  }
}

TEST(Bottlenecks, OfNoPlaceIsNone) {
  BallSet balls = no_balls();
  add_ball(balls, 0, 0, 0, 1000);
  EXPECT_TRUE(find_bottlenecks(balls, {}).of.empty());
  EXPECT_THROW(find_bottlenecks(no_balls(), {{0, 0, 0}}), std::invalid_argument);
}

// Finds the widest place of a cavity, and of its mouth.
TEST(CavityPlaces, OfAChamberWithOneMouth) {
  BallSet balls = no_balls();
  add_tube(balls, -10, 10);
  add_ball(balls, 0, 0, -10000, 2000);
  add_ring(balls, 8, 2.5, -10, 2);
  add_ring(balls, 12, 4.5, 10, 2);  // 2.5 Å wide, the way out
  const auto shared = std::make_shared<const BallSet>(balls);
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      shared, std::make_shared<const Triangulation>(make_triangulation(balls, 1, {}))));
  const CavityTable table = make_cavity_table(ground, {});
  ASSERT_GE(table.size(), 1u);
  const Cavity& cavity = table.cavity(0);
  ASSERT_FALSE(cavity.mouths.empty());  // the wide one, and slits between the last rings
  const Clearance clearance(balls);
  const WidestPlace chamber = widest_place(*ground, cavity, clearance);
  EXPECT_NEAR(chamber.clearance_angstrom, 4, 0.1);
  EXPECT_LT(std::hypot(chamber.place_angstrom.x, chamber.place_angstrom.y), 0.1);
  WidestPlace mouth = widest_place(*ground, cavity.mouths[0], clearance);
  for (const Mouth& other : cavity.mouths) {
    const WidestPlace place = widest_place(*ground, other, clearance);
    if (place.clearance_angstrom > mouth.clearance_angstrom) mouth = place;
  }
  EXPECT_NEAR(mouth.clearance_angstrom, 2.5, 0.05);
  EXPECT_NEAR(mouth.place_angstrom.z, 10, 1.0);
  const Bottlenecks found = find_bottlenecks(balls, {chamber.place_angstrom});
  EXPECT_NEAR(found.of[0].radius_angstrom, 2.5, 0.0015);
}

}  // namespace
}  // namespace alphascope
