// SPDX-License-Identifier: GPL-3.0-or-later
// Tests channels as derived results. Each answer belongs to its own question, and a question
// without an answer gives a reason.
#include "core/document/channels/channel_results.hpp"

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_bottlenecks.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/store/inputs.hpp"
#include "core/triangulation/flow.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/core/document/store/store_fixture.hpp"

namespace alphascope {
namespace {

struct ChannelResultsTest : testing::StoreTest {
  void SetUp() override {
    budget = 4'000'000'000;
    BallSet balls = testing::no_balls();
    testing::add_tube(balls, -10, 10);
    testing::add_ball(balls, 0, 0, -10000, 2000);
    testing::add_ring(balls, 8, 2.5, -10, 2);
    testing::add_ring(balls, 12, 4.5, 9, 2);  // 2.5 Å out
    plain.balls = std::make_shared<const BallSet>(balls);
    plain.balls_key = 1;
    plain.alpha_angstrom2 = 0;
    grown = plain;
    grown.balls = std::make_shared<const BallSet>(with_solvent(balls, 1.4));
    grown.balls_key = 2;
    grown.solvent_radius_angstrom = 1.4;
  }
  Inputs plain, grown;
};

TEST_F(ChannelResultsTest, EachIsOfItsQuestion) {
  const auto inside = settle(found_channel(ChannelEnds::out({0, 0, 0})), plain);
  ASSERT_TRUE(inside.ready() && inside.value->channel);
  EXPECT_NEAR(inside.value->channel->widest_angstrom, 2.5, 0.0015);
  const auto outside = settle(found_channel(ChannelEnds::out({0, 0, 14})), plain);
  ASSERT_TRUE(outside.ready() && outside.value->channel);
  EXPECT_GT(outside.value->channel->widest_angstrom, 3);
  EXPECT_NE(inside.have, outside.have);
  // Earlier answers are still held.
  EXPECT_EQ(settle(found_channel(ChannelEnds::out({0, 0, 0})), plain).value, inside.value);
}

TEST_F(ChannelResultsTest, APointInABallIsAnAnswer) {
  const auto covered = settle(found_channel(ChannelEnds::out({6, 0.5, 0})), plain);
  ASSERT_TRUE(covered.ready());
  EXPECT_FALSE(covered.value->channel);
  ASSERT_TRUE(covered.value->covering);
  EXPECT_GT(covered.value->depth_angstrom, 1);
  const auto nowhere = settle(found_channel(ChannelEnds::through({0, 0, 50}, {1, 0, 0})), plain);
  ASSERT_TRUE(nowhere.ready());
  EXPECT_FALSE(nowhere.value->covering);
  EXPECT_FALSE(nowhere.value->why.empty());
}

// The solvent radius is subtracted again, also on the finer lattice that it may need.
TEST_F(ChannelResultsTest, TheSolventIsTakenAway) {
  EXPECT_EQ(without_solvent(*grown.balls, 1.4).radii, plain.balls->radii);
  const BallSet finer = with_solvent(*plain.balls, 1.40005);
  const BallSet back = without_solvent(finer, 1.40005);
  EXPECT_EQ(back.radii, on_finer_lattice(*plain.balls, finer.lattice.digits).radii);
}

TEST_F(ChannelResultsTest, EndsAndBottlenecksAreOfTheTableOnScreen) {
  const auto table = settle(cavity_table(), grown).value;
  ASSERT_TRUE(table);
  ASSERT_GE(table->size(), 1u);
  const auto ends = settle(cavity_ends(table->sink(0)), grown).value;
  ASSERT_TRUE(ends && ends->found);
  EXPECT_NEAR(ends->found->widest.clearance_angstrom, 4, 0.1);
  EXPECT_EQ(ends->found->mouths.size(), table->cavity(0).mouths.size());
  const auto narrow = settle(cavity_bottlenecks(), grown).value;
  ASSERT_TRUE(narrow);
  ASSERT_EQ(narrow->rows.size(), table->size());
  // Without the solvent radius the number is the same for each of its values.
  EXPECT_NEAR(narrow->rows[0].radius_angstrom, 2.5, 0.0015);
  const auto none = settle(cavity_ends({0, 1, 2, 3}), grown).value;
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->found);
}

}  // namespace
}  // namespace alphascope
