// SPDX-License-Identifier: GPL-3.0-or-later
// Tests when balls are left out while something moves, which frame shows the first picture, and the
// timings of a picture.
#include "app/viewer/scene/ball_stand_in.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdint>

#include "core/run/picture_stages.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope {
namespace {

TEST(BallStandIn, OnlyForSlowPicturesThatMove) {
  BallStandIn balls;
  EXPECT_FALSE(balls.wanted(false, true)) << "nothing is known yet";
  const double slow = BallStandIn::kMost + 1;
  balls.note(RenderQuality::sketch, slow);
  EXPECT_FALSE(balls.wanted(false, true)) << "shaders may have been compiled";
  balls.note(RenderQuality::sketch, slow);
  EXPECT_TRUE(balls.wanted(false, true));
  EXPECT_FALSE(balls.wanted(true, true)) << "at rest all is drawn";
  EXPECT_FALSE(balls.wanted(false, false)) << "the picture would be empty";
  balls.note(RenderQuality::fine, 1);
  EXPECT_TRUE(balls.wanted(false, true)) << "of another quality";
  balls.note(RenderQuality::draft, slow);
  EXPECT_FALSE(balls.wanted(false, true)) << "a sketch has fewer pixels";
  balls.note(RenderQuality::draft, 10 * slow);
  EXPECT_FALSE(balls.wanted(false, true)) << "two in a row are slow at least";
  balls.note(RenderQuality::draft, 10 * slow);
  EXPECT_TRUE(balls.wanted(false, true));
  balls.forget();
  EXPECT_FALSE(balls.wanted(false, true));
}

class FirstPicture : public testing::ViewerTest {
 protected:
  FirstPicture() : ViewerTest(false) {}
  std::uint64_t texture() const { return viewer_->state().viewport.texture; }
  bool frame_shows_it() const {
    const ImDrawData* const drawn = ImGui::GetDrawData();
    for (int list = 0; list < drawn->CmdListsCount; ++list) {
      for (const ImDrawCmd& command : drawn->CmdLists[list]->CmdBuffer) {
        if (reinterpret_cast<std::uintptr_t>(command.GetTexID()) == texture()) return true;
      }
    }
    return false;
  }
};

TEST_F(FirstPicture, IsInTheFrameThatDrawsIt) {
  run("frames 2\n");
  EXPECT_EQ(texture(), 0u) << "nothing is open";
  run("open " + testing::crambin().string() + "\n");
  ScriptedInput no_input;
  while (texture() == 0 && viewer_->state().error.empty()) viewer_->step(&no_input);
  EXPECT_TRUE(frame_shows_it());
}

class PictureStages : public testing::ViewerTest {
 protected:
  void expect_stages_of_picture() {
    run("click alpha.preset.3\nwait-idle\nclick alpha.preset.1.4\nwait-idle\nframes 2\n");
    viewer_->finish_frame();
    run("frames 1\n");
    const auto& run_of = viewer_->state().ours.warm;
    ASSERT_TRUE(run_of);
    const auto& stages = run_of->times.stages;
    ASSERT_GE(stages.size(), 4u);
    const auto first = stages.end() - 3;
    EXPECT_EQ(first[0].label, stage::kMesh);
    EXPECT_EQ(first[1].label, stage::kUpload);
    EXPECT_EQ(first[2].label, stage::kDraw);
    for (int i = 0; i < 3; ++i) EXPECT_GT(first[i].milliseconds, 0) << first[i].label;
    double engine = 0;
    for (auto s = stages.begin(); s != first; ++s) engine += s->milliseconds;
    EXPECT_LE(engine, 1.01 * run_of->times.wall_milliseconds);
  }
};

// The picture's stages follow those of the engine. Only the engine's stages add up to its wall
// time.
TEST_F(PictureStages, FollowTheEnginesInItsTimings) {
  open_crambin();
  expect_stages_of_picture();
}

TEST_F(PictureStages, AreKnownAfterwardsWhereTheWindowGoesOnMeanwhile) {
  open_crambin();
  const auto finished = [&] {
    run("click alpha.preset.10\nwait-idle\n");
    shot("finished.png");  // only then it has all samples
    return testing::texture_pixels(static_cast<unsigned>(viewer_->state().viewport.texture));
  };
  const Image before = finished();
  viewer_->render_asynchronously();
  expect_stages_of_picture();
  EXPECT_EQ(finished().rgba, before.rgba);
}

}  // namespace
}  // namespace alphascope
