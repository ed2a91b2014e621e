// The page of channels in the whole window: ends that are clicked, the bottleneck and its profile,
// the tube in the picture.
#include "core/document/channel_texts.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/channel_parts.hpp"

namespace alphascope::testing {
namespace {

class ChannelsTest : public ViewerTest {
 protected:
  // A tube along z, 4 Å wide inside, with a ring of 2.5 Å near its top; closed below or open.
  void open_tube(bool closed) {
    BallSet balls = no_balls();
    add_tube(balls, -14, 14);
    add_ring(balls, 12, 4.5, 9, 2);
    if (closed) {
      add_ball(balls, 0, 0, -14000, 2000);
      add_ring(balls, 8, 2.5, -14, 2);
    }
    const fs::path path = folder_ / (closed ? "closed.xyzr" : "open.xyzr");
    std::ofstream file(path);
    for (BallIndex i = 0; i < balls.size(); ++i) {
      const LatticePoint& p = balls.centres[i];
      file << p.x / 1000.0 << ' ' << p.y / 1000.0 << ' ' << p.z / 1000.0 << ' '
           << balls.radii[i] / 1000.0 << '\n';
    }
    file.close();
    run("open " + path.string() + "\nwait-idle\nclick bottom.channels\n");
    settle();
  }
  void settle() { run("frames 3\nwait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  const ChannelMemory& memory() { return viewer_->state().memory.channels; }
  const Channel& channel() { return *memory().shown->channel; }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  bool has_layer(const std::string& id) {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == id) return true;
    }
    return false;
  }
};

TEST_F(ChannelsTest, OfAPoreIsThereUponTheFirstClick) {
  open_tube(false);
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_NEAR(channel().widest_angstrom, 2.5, 0.0015);
  EXPECT_NEAR(channel().narrowest().position_angstrom.z, 9, 0.05);
  EXPECT_TRUE(has("channels.result"));
  EXPECT_TRUE(has("channels.profile"));
  EXPECT_TRUE(has("channels.legend"));
  EXPECT_TRUE(has_layer("channels.bottleneck"));
  EXPECT_TRUE(has_layer("channels.tube.2"));
  EXPECT_FALSE(has_layer("channels.tube.1")) << "nowhere below 2.3 Å";
  // The place under the mouse is marked in the view.
  run("move channels.profile 0.5 0.5\nframes 3\n");
  EXPECT_TRUE(has_layer("channels.cursor"));
  run("move status.device\nframes 3\n");
  EXPECT_FALSE(has_layer("channels.cursor"));
}

TEST_F(ChannelsTest, NeitherSolventNorAlphaChangesIt) {
  open_tube(false);
  const auto before = memory().shown;
  ASSERT_TRUE(before);
  run("alpha.set 1\nwait-idle\n");
  settle();
  EXPECT_EQ(memory().shown, before);
  EXPECT_TRUE(has_layer("channels.bottleneck"));
  run("solvent.set 1.4\nwait-idle\n");
  settle();
  ASSERT_EQ(viewer_->state().result->request.solvent_radius_angstrom, 1.4);
  EXPECT_EQ(memory().shown, before);
  EXPECT_TRUE(has_layer("channels.bottleneck")) << "of the balls that are drawn now";
}

TEST_F(ChannelsTest, ShowingTheBottleneckSelectsTheAtomsThatTouchIt) {
  open_tube(false);
  run("click channels.show\nwait-idle\n");
  EXPECT_EQ(viewer_->state().picked.items.size(), channel().touching.size());
  EXPECT_GE(channel().touching.size(), 3u);
}

TEST_F(ChannelsTest, AChosenCavityLeadsOut) {
  open_tube(true);
  run("click bottom.cavities\nwait-idle\n");
  settle();
  run("click cavities.row.1 0.2\nwait-idle\nclick bottom.channels\n");
  settle();
  EXPECT_EQ(memory().from, ChannelFrom::cavity);
  EXPECT_EQ(memory().to, ChannelTo::out);
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_NEAR(channel().widest_angstrom, 2.5, 0.0015);
  EXPECT_LT(channel().samples.front().position_angstrom.z, 8.5) << "it begins in the chamber";
  // Another mouth than it has is refused in words.
  run("click channels.to\nclick channels.to.3\nclick channels.to.mouth\nkey ctrl+a\ntype 999\n"
      "key enter\n");
  settle();
  EXPECT_TRUE(has("channels.problem"));
  EXPECT_FALSE(has_layer("channels.bottleneck")) << "of another question";
}

TEST_F(ChannelsTest, WithoutACavityItLeadsToTheirPage) {
  open_tube(true);
  run("click channels.from\nclick channels.from.0\n");
  settle();
  ASSERT_TRUE(has("channels.cavities"));
  run("click channels.cavities\nframes 3\n");
  EXPECT_EQ(viewer_->state().memory.bottom_panel, "cavities");
}

TEST_F(ChannelsTest, APointInAnAtomIsNamedWithARemedy) {
  open_tube(true);
  run("click channels.to\nclick channels.to.0\nclick channels.from\nclick channels.from.4\n"
      "click channels.from.x\nkey ctrl+a\ntype 5.9\nkey enter\n");
  settle();
  ASSERT_TRUE(memory().shown);
  EXPECT_FALSE(memory().shown->channel);
  EXPECT_TRUE(memory().shown->covering);
  EXPECT_NE(memory().covering.find('#'), std::string::npos) << memory().covering;
  EXPECT_TRUE(has("channels.problem"));
  EXPECT_FALSE(has("channels.profile"));
}

TEST_F(ChannelsTest, AClosedOneSaysSo) {
  open_tube(true);
  run("click channels.to\nclick channels.to.1\nclick channels.axis\nclick channels.axis.3\n"
      "click channels.turn\n");
  settle();
  EXPECT_TRUE(memory().backwards);
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_FALSE(channel().is_open());
  EXPECT_TRUE(has("channels.result"));
}

TEST_F(ChannelsTest, OfAnotherMoleculeNothingStays) {
  open_tube(false);
  const auto before = memory().shown;
  run("click bottom.timings\n");
  open_crambin();
  run("click bottom.channels\nframes 1\n");
  EXPECT_NE(memory().shown, before);
  EXPECT_FALSE(has_layer("channels.bottleneck") && memory().shown == before);
}

TEST_F(ChannelsTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.channels\n");
  EXPECT_TRUE(has("channels.waiting"));
  EXPECT_FALSE(has("channels.from"));
}

TEST(ChannelProfile, AsCsvHasALineForEachSample) {
  Channel channel;
  channel.samples = {{{1, 2, 3}, 0.5, 0}, {{1, 2, 3.1}, 0.25, 0.1}};
  EXPECT_EQ(channel_profile_csv(channel),
            "along_angstrom,radius_angstrom,x_angstrom,y_angstrom,z_angstrom\n"
            "0,0.5,1,2,3\n0.1,0.25,1,2,3.1\n");
}

TEST(ChannelTexts, BandsAreThoseOfHole) {
  EXPECT_EQ(water_band(1.149), WaterBand::none);
  EXPECT_EQ(water_band(1.15), WaterBand::one);
  EXPECT_EQ(water_band(2.30), WaterBand::several);
}

}  // namespace
}  // namespace alphascope::testing
