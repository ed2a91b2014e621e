// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page of channels in the whole window. Clicks set ends, the bottleneck and its profile
// are shown, and the tube is in the picture.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cavity/cavity_table.hpp"
#include "core/document/channels/channel_text.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/viewport_info.hpp"

namespace alphascope::testing {
namespace {

class ChannelsTest : public ViewerTest {
 protected:
  // A tube along z, 4 Å wide inside, with a ring of 2.5 Å near its top. It is closed or open below.
  void open_tube(bool closed) {
    BallSet balls = no_balls();
    add_tube(balls, -14, 14);
    add_ring(balls, 12, 4.5, 9, 2);
    if (closed) {
      add_ball(balls, 0, 0, -14000, 2000);
      add_ring(balls, 12, 3, -14, 2);
    }
    open_balls(balls, closed ? "closed.xyzr" : "open.xyzr");
  }
  void open_balls(const BallSet& balls, const char* name) {
    const fs::path path = folder_ / name;
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
  const ChannelState& memory() { return viewer_->state().channels; }
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
  ASSERT_TRUE(has_layer("channels.tube"));
  const Layer& tube = *memory().layers.at(0);
  EXPECT_EQ(tube.tubes.at(0).size(), channel().samples.size());
  EXPECT_TRUE(tube.body && tube.fades_rest) << "the molecule would hide it";
  ASSERT_EQ(tube.labels.size(), 1u);
  // The radius of the largest sphere that passes, as on the command line: no other rounding.
  const std::string radius = bottleneck_radius_text(channel()) + " Å";
  EXPECT_EQ(tube.labels[0].text, radius);
  EXPECT_NE(tube.name.find("narrowest radius " + radius), std::string::npos) << tube.name;
  // The place under the mouse is marked in the view.
  run("move channels.profile 0.5 0.5\nframes 3\n");
  EXPECT_TRUE(has_layer("channels.cursor"));
  run("move status.memory\nframes 3\n");
  EXPECT_FALSE(has_layer("channels.cursor"));
}

// Pale balls lie before the tube, and it is found nevertheless.
TEST_F(ChannelsTest, TheTubeHasANameUnderTheMouse) {
  open_tube(false);
  ASSERT_TRUE(has_layer("channels.tube"));
  run("move view 0.5 0.5\nframes 3\n");
  const ViewportInfo& view = viewer_->state().viewport;
  EXPECT_EQ(view.under_mouse, "Channel through the whole molecule  ·  narrowest radius 2.499 Å");
  EXPECT_EQ(view.under_mouse_line, view.under_mouse);
  run("click bottom.timings\nframes 3\nmove view 0.5 0.5\nframes 3\n");
  EXPECT_EQ(view.under_mouse.find("Channel"), std::string::npos) << "it is no longer drawn";
}

TEST_F(ChannelsTest, AClickOnTheTubeOpensThePage) {
  open_tube(false);
  run("click bottom.structure\nframes 3\nclick structure.channels\n");
  settle();
  run("click structure.channel.1\nmove status.memory\n");
  settle();
  ASSERT_EQ(viewer_->state().window.page, "structure");
  run("move view 0.5 0.5\nframes 3\nclick view 0.5 0.5\nframes 3\n");
  EXPECT_EQ(viewer_->state().window.page, "channels");
  EXPECT_TRUE(viewer_->state().settings.selection.items.empty());
}

// Two chains, each a tube with a way of its own. The wider way is shown first, and a click takes
// the other one.
TEST_F(ChannelsTest, WaysAreListedAndAClickTakesOne) {
  const fs::path path = folder_ / "two.pdb";
  std::ofstream file(path);
  int number = 0;
  for (const char chain : {'A', 'B'}) {
    for (int z = -12; z <= 12; z += 2) {
      const double away = z != 0 ? 5.5 : chain == 'A' ? 4.6 : 5.0;
      for (int k = 0; k < 16; ++k) {
        const double angle = 2 * std::numbers::pi * k / 16;
        char line[100];
        ++number;
        std::snprintf(line, sizeof line,
                      "ATOM  %5d  CA  ALA %c%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                      number, chain, number, (chain == 'A' ? -8.5 : 8.5) + away * std::cos(angle),
                      away * std::sin(angle), 1.0 * z);
        file << line;
      }
    }
  }
  file << "END\n";
  file.close();
  run("open " + path.string() + "\nwait-idle\nclick bottom.channels\n");
  settle();
  ASSERT_TRUE(has("channels.way.1") && has("channels.way.2"));
  ASSERT_TRUE(memory().shown && memory().shown->way);
  EXPECT_EQ(memory().way, 1u);
  EXPECT_EQ(memory().shown->way->through, "chain B");
  const double wider = channel().widest_angstrom;
  EXPECT_TRUE(has("channels.passing") && has("channels.cover"));
  EXPECT_FALSE(has("channels.to")) << "it has no other end";
  ASSERT_TRUE(has_layer("channels.tube"));
  run("click channels.way.2\nframes 3\n");
  EXPECT_EQ(memory().way, 2u);
  EXPECT_EQ(memory().shown->way->through, "chain A");
  EXPECT_NEAR(wider - channel().widest_angstrom, 0.4, 0.002);
  EXPECT_TRUE(has_layer("channels.tube"));
  // The tree of the page Structure has the same ways. The one under the mouse is drawn, or else the
  // chosen one.
  run("view.page structure\nwait-idle\nframes 3\nclick structure.channels\n");
  settle();
  ASSERT_TRUE(has("structure.channel.2"));
  EXPECT_FALSE(has_layer("channels.tube")) << "none is chosen there";
  run("click structure.channel.2\n");
  settle();
  run("move structure.channel.1\nframes 3\n");
  EXPECT_TRUE(has_layer("channels.tube"));
  EXPECT_EQ(memory().shown->way->through, "chain B");
  run("move status.memory\nframes 3\n");
  EXPECT_EQ(memory().shown->way->through, "chain A");
  EXPECT_EQ(memory().way, 2u);
}

TEST_F(ChannelsTest, ACupHasNoWayThrough) {
  open_tube(true);
  EXPECT_FALSE(memory().shown);
  EXPECT_TRUE(has("channels.problem"));
  EXPECT_FALSE(has("channels.way.1"));
  // A channel that ends inside the molecule gives no verdict on the whole way.
  run("click channels.from\nclick channels.from.3\nclick channels.to\nclick channels.to.0\n");
  settle();
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_FALSE(memory().shown->is_whole());
}

TEST_F(ChannelsTest, NeitherSolventNorAlphaChangesIt) {
  open_tube(false);
  const auto before = memory().shown;
  ASSERT_TRUE(before);
  run("alpha.set 1\nwait-idle\n");
  settle();
  EXPECT_EQ(memory().shown, before);
  EXPECT_TRUE(has_layer("channels.tube"));
  run("solvent.set 1.4\nwait-idle\n");
  settle();
  ASSERT_EQ(viewer_->state().result->request.solvent_radius_angstrom, 1.4);
  EXPECT_EQ(memory().shown, before);
  EXPECT_TRUE(has_layer("channels.tube")) << "of the balls that are drawn now";
}

TEST_F(ChannelsTest, ShowingTheBottleneckSelectsTheAtomsThatTouchIt) {
  open_tube(false);
  run("click channels.show\nwait-idle\n");
  EXPECT_EQ(viewer_->state().settings.selection.items.size(), channel().touching.size());
  EXPECT_GE(channel().touching.size(), 3u);
}

// The view turns to the channel's side. From an end, the wide part would hide the narrow one.
TEST_F(ChannelsTest, IsSeenFromTheSide) {
  open_tube(false);
  for (const char* name : {"channels.show", "channels.across"}) {
    run(std::string("view.from z\nframes 3\nwait-idle\n"));
    EXPECT_NEAR(std::fabs(viewer_->state().viewport.into_view.z), 1, 1e-9) << name;
    run(std::string("click ") + name + "\nframes 3\nwait-idle\nframes 3\n");
    EXPECT_NEAR(viewer_->state().viewport.into_view.z, 0, 0.1) << name;
  }
  const ViewportInfo& view = viewer_->state().viewport;
  EXPECT_GE(std::min(view.width, view.height) * view.angstrom_per_pixel, 28) << "all of it";
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
  // A mouth that the cavity does not have is refused in words.
  run("click channels.to\nclick channels.to.3\nclick channels.to.mouth\nkey ctrl+a\ntype 999\n"
      "key enter\n");
  settle();
  EXPECT_TRUE(has("channels.problem"));
  EXPECT_FALSE(has_layer("channels.tube")) << "of another question";
}

TEST_F(ChannelsTest, WithoutACavityItLeadsToTheirPage) {
  open_tube(true);
  run("click channels.from\nclick channels.from.0\n");
  settle();
  ASSERT_TRUE(has("channels.cavities"));
  run("click channels.cavities\nframes 3\n");
  EXPECT_EQ(viewer_->state().window.page, "cavities");
}

TEST_F(ChannelsTest, APointInAnAtomIsNamedWithARemedy) {
  open_tube(true);
  run("click channels.from\nclick channels.from.4\nclick channels.to\nclick channels.to.0\n"
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
  run("click channels.from\nclick channels.from.3\n"
      "click channels.to\nclick channels.to.1\nclick channels.axis\nclick channels.axis.3\n"
      "click channels.turn\n");
  settle();
  EXPECT_TRUE(memory().backwards);
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_FALSE(channel().is_open());
  EXPECT_TRUE(has("channels.result"));
}

// For example potassium in the filter of a potassium channel.
TEST_F(ChannelsTest, AnIonInThePoreCanBeLeftOut) {
  const fs::path path = folder_ / "pore.pdb";
  std::ofstream file(path);
  const auto atom = [&](const char* kind, const char* name, const char* residue, int number,
                        const RealPoint& p) {
    char line[100];
    std::snprintf(line, sizeof line, "%-6s%5d %-4s %3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00\n", kind,
                  number, name, residue, number, p.x, p.y, p.z);
    file << line;
  };
  int number = 0;
  for (int z = -6; z <= 6; z += 2) {
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * std::numbers::pi * k / 16;
      atom("ATOM", " CA", "ALA", ++number, {5 * std::cos(angle), 5 * std::sin(angle), 1.0 * z});
    }
  }
  atom("HETATM", " K", "K", ++number, {0.1, 0, 0});
  file << "END\n";
  file.close();
  run("open " + path.string() + "\nwait-idle\nclick bottom.channels\n");
  settle();
  // The way through is as wide as without the ion, and a note says so.
  ASSERT_TRUE(memory().shown && memory().shown->channel && memory().shown->way);
  EXPECT_EQ(memory().shown->way->ions, 1u);
  EXPECT_TRUE(has("channels.not_counted"));
  EXPECT_FALSE(has("channels.guests"));
  const double as_way = channel().widest_angstrom;
  run("click channels.from\nclick channels.from.3\n"
      "click channels.axis\nclick channels.axis.3\n");
  settle();
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  const double blocked = channel().widest_angstrom;
  EXPECT_LT(blocked, 2);
  ASSERT_TRUE(has("channels.guests"));
  run("click channels.guests\nwait-idle\n");
  settle();
  EXPECT_FALSE(viewer_->state().settings.open.balls.ions);
  ASSERT_TRUE(memory().shown && memory().shown->channel);
  EXPECT_GT(channel().widest_angstrom, blocked + 1);
  EXPECT_NEAR(channel().widest_angstrom, as_way, 0.02);
  EXPECT_FALSE(has("channels.guests"));
}

TEST_F(ChannelsTest, OfAnotherMoleculeNothingStays) {
  open_tube(false);
  const auto before = memory().shown;
  run("click bottom.timings\n");
  open_crambin();
  run("click bottom.channels\nframes 1\n");
  EXPECT_NE(memory().shown, before);
  EXPECT_FALSE(has_layer("channels.tube") && memory().shown == before);
}

TEST_F(ChannelsTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.channels\n");
  EXPECT_TRUE(has("channels.waiting"));
  EXPECT_FALSE(has("channels.from"));
}

TEST_F(ChannelsTest, SavesWhatItCopiesAndAllOfTheChannelAsJson) {
  open_tube(false);
  ASSERT_TRUE(has("channels.save"));
  run("click channels.copy\nframes 2\n");
  const std::string copied = ImGui::GetClipboardText();
  EXPECT_EQ(copied.find("along_angstrom,radius_angstrom,x_angstrom,y_angstrom,z_angstrom,file,"),
            0u);
  EXPECT_EQ(std::count(copied.begin(), copied.end(), '\n'),
            static_cast<long>(channel().samples.size()) + 1);
  run("click channels.save\nframes 3\n");
  viewer_->state().save_table.path = (folder_ / "c.csv").string();
  run("click save_table.ok\n");
  settle();
  EXPECT_EQ(bytes("c.csv"), copied);
  run("click channels.save\nframes 3\nclick save_table.format\nframes 2\n"
      "click save_table.json\nframes 2\n");
  viewer_->state().save_table.path = (folder_ / "c.json").string();
  run("click save_table.ok\n");
  settle();
  const std::string json = bytes("c.json");
  for (const char* key :
       {"\"widest_angstrom\": 2.", "\"kind\": \"way\"", "\"through\": \"the whole molecule\"",
        "\"bottleneck\"", "\"sha256\"", "\"name\": \"alphascope\""}) {
    EXPECT_NE(json.find(key), std::string::npos) << key;
  }
}

// A channel is saved in the formats of cavities. A script is saved with the files that it opens.
TEST_F(ChannelsTest, IsSavedForOtherPrograms) {
  open_tube(false);
  const auto save = [&](const std::string& name) {
    run("click channels.save\nframes 3\n");
    viewer_->state().save_table.path = (folder_ / name).string();
    run("frames 2\nclick save_table.ok\n");
    settle();
    run("wait-idle\nframes 3\n");
    EXPECT_EQ(viewer_->state().error, "");
    return bytes(name);
  };
  EXPECT_TRUE(save("c.ply").starts_with("ply\n"));
  EXPECT_TRUE(save("c.glb").starts_with("glTF"));
  const std::string spheres = save("c.pqr");
  std::size_t atoms = 0;
  for (std::size_t at = 0; (at = spheres.find("  SPH CHN C", at)) != spheres.npos; ++at) ++atoms;
  EXPECT_EQ(atoms, channel().samples.size());
}

TEST(ChannelTexts, BandsAreThoseOfHole) {
  EXPECT_EQ(water_band(1.149), WaterBand::none);
  EXPECT_EQ(water_band(1.15), WaterBand::one);
  EXPECT_EQ(water_band(2.30), WaterBand::several);
}

}  // namespace
}  // namespace alphascope::testing
