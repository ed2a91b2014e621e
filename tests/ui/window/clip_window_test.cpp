// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the clip in the whole window: its panel, its handle, commands, undo, and picking. Also
// tests saved cameras and views along axes.
#include <cmath>
#include <cstdlib>

#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class ClipWindow : public ViewerTest {
 protected:
  ClipWindow() {
    open_crambin();
    // Shadows change the picture at rest, which is not under test here.
    run("view.shadows off\nwait-idle\n");
  }
  const Clip& clip() const { return viewer_->state().settings.clip; }
  const ViewportInfo& view() const { return viewer_->state().viewport; }
  void undo() { run("edit.undo\nwait-idle\n"); }
};

TEST_F(ClipWindow, ThePanelCutsThroughTheMiddleAndBack) {
  const Image whole = picture();
  run("click clip.kind.1\nwait-idle\n");
  EXPECT_EQ(clip().kind, Clip::Kind::plane);
  // The clip faces the viewer and goes through the middle of the balls.
  EXPECT_NEAR(clip().normal[0], -view().into_view.x, 1e-12);
  const Image half = picture();
  EXPECT_GT(differing_pixels(half, whole), 2000);
  run("click clip.across.0\nwait-idle\n");
  EXPECT_EQ(clip().normal, (std::array<double, 3>{1, 0, 0}));
  EXPECT_NEAR(clip().position, view().box_middle[0], 1e-9);
  run("click clip.kind.2\nwait-idle\n");
  EXPECT_EQ(clip().kind, Clip::Kind::slab);
  EXPECT_EQ(viewer_->state().undo_text, "clip");
  run("click clip.kind.0\nwait-idle\n");
  EXPECT_EQ(differing_pixels(picture(), whole), 0);
  undo();
  EXPECT_EQ(clip().kind, Clip::Kind::slab);
  undo();
  undo();
  EXPECT_EQ(differing_pixels(picture(), half), 0);
  undo();
  EXPECT_EQ(clip(), Clip{});
}

TEST_F(ClipWindow, ADragOfTheSliderIsOneEntry) {
  run("view.clip x\nwait-idle\n");
  const double before = clip().position;
  run("move clip.position 0.5\ndown\nmove clip.position 0.6\nmove clip.position 0.8\nup\nframes "
      "3\n");
  EXPECT_GT(clip().position, before + 2);
  undo();
  EXPECT_EQ(clip().position, before);
}

TEST_F(ClipWindow, TheHandleMovesAndTurnsTheCutAndNotTheCamera) {
  run("view.from x\nview.clip z\nwait-idle\nframes 3\n");
  const Clip before = clip();
  const RealPoint into = view().into_view;
  ASSERT_TRUE(view().clip_handle.shown);
  run("move view.clip_handle\ndown\nmove view.clip_handle 0.5 -3\nmove view.clip_handle 0.5 "
      "-6\nup\n"
      "frames 3\n");
  EXPECT_EQ(view().into_view, into);
  EXPECT_NE(clip().position, before.position);
  EXPECT_EQ(clip().normal, before.normal);
  undo();
  EXPECT_EQ(clip(), before);
  run("move view.clip_ring\ndown\nmove view.clip_ring 4 3\nmove view.clip_ring 6 5\nup\nframes "
      "3\n");
  EXPECT_EQ(view().into_view, into);
  EXPECT_NE(clip().normal, before.normal);
  undo();
  EXPECT_EQ(clip(), before);
  // Beside the handle the mouse turns the view.
  run("move view 0.05 0.5\ndown\nmove view 0.1 0.6\nup\nframes 3\n");
  EXPECT_NE(view().into_view, into);
  EXPECT_EQ(clip(), before);
}

TEST_F(ClipWindow, WhatIsCutAwayIsNotUnderTheMouse) {
  run("view.clip off\nmove view 0.5 0.5\nwait-idle\nframes 3\n");
  const std::string whole = view().under_mouse_line;
  // Balls fill little of the picture. Larger ones leave no gaps.
  viewer_->state().settings.display.ball_scale = 1;
  run("frames 3\nwait-idle\nmove view 0.5 0.45\nframes 3\n");
  const std::string front = view().under_mouse_line;
  ASSERT_NE(front, "");
  run("view.clip view\nview.clip_move -3\nwait-idle\nmove view 0.5 0.45\nframes 3\n");
  viewer_->state().window.clip_handle = false;
  run("frames 3\nmove view 0.5 0.45\nframes 3\n");
  EXPECT_NE(view().under_mouse_line, front);
  run("view.clip_move -1000\nwait-idle\nframes 3\n");
  EXPECT_EQ(view().under_mouse_line, "");
  EXPECT_EQ(view().problem, ViewProblem::cut_away);
  run("click view.no_clip\nwait-idle\nmove view 0.5 0.45\nframes 3\n");
  EXPECT_EQ(view().under_mouse_line, front);
}

TEST_F(ClipWindow, CapsFollowAlphaAndTheClip) {
  run("view.balls off\nalpha.set 3\nview.clip view\nwait-idle\n");
  const Image at_3 = picture();
  run("alpha.set 10\nwait-idle\n");
  EXPECT_GT(differing_pixels(picture(), at_3), 1000);
  run("alpha.set 3\nwait-idle\n");
  EXPECT_EQ(differing_pixels(picture(), at_3), 0);
  run("view.clip_move 4\nwait-idle\n");
  EXPECT_GT(differing_pixels(picture(), at_3), 1000);
}

TEST_F(ClipWindow, SavedPicturesAndTheCommandLineShowTheSame) {
  run("view.edges on\nview.triangles on\nalpha.set 3\nview.clip x=9.5\nwait-idle\n");
  const int width = view().width, height = view().height;
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "window.png", {.width = width, .height = height}});
  run("wait-idle\n");
  const Image window = pixels_of(folder_ / "window.png");
  DisplaySettings& display = viewer_->state().settings.display;
  const DisplaySettings usual;
  display.ambient_occlusion = usual.ambient_occlusion;
  display.depth_cue = usual.depth_cue;
  display.outlines = usual.outlines;
  display.samples = 4;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const auto drawn = [&](const std::string& options) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + crambin().string() +
                                " --alpha 3 --samples 4 --size " + size + " " + options + " -o " +
                                (folder_ / "cli.png").string() + " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return pixels_of(folder_ / "cli.png");
  };
  run("wait-idle\n");
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "window.png", {.width = width, .height = height}});
  run("wait-idle\n");
  const Image shaded = pixels_of(folder_ / "window.png");
  EXPECT_LE(share_unlike(shaded, drawn("--clip x=9.5")), 0.001);
  EXPECT_GT(share_unlike(shaded, drawn("--clip x=12")), 0.01);
}

TEST_F(ClipWindow, CommandsTakeAClipAndSayWhatIsWrong) {
  run("view.clip z=4:6\n");
  EXPECT_EQ(clip_text(clip()), "z=4:6");
  run("view.clip_move 1.5\n");
  EXPECT_EQ(clip_text(clip()), "z=5.5:6");
  EXPECT_EQ(viewer_->commands().run_line("view.clip sideways").state, Outcome::State::refused);
  EXPECT_EQ(clip_text(clip()), "z=5.5:6");
  EXPECT_NE(viewer_->commands().run_line("view.clip_flip").why, "");
  run("key k\n");
  EXPECT_FALSE(clip().on());
  run("key k\nframes 2\nview.clip_flip\n");
  EXPECT_TRUE(clip().flipped);
  run("view.clip_face\nframes 3\n");
  EXPECT_NEAR(view().into_view.z, 1, 1e-9);  // from the side that is cut away
}

TEST_F(ClipWindow, AnotherFileIsNotCut) {
  run("view.clip x\nwait-idle\nfile.sample haemoglobin\nwait-idle\n");
  EXPECT_EQ(clip(), Clip{});
}

TEST_F(ClipWindow, ViewsAlongAxesAndSavedCamerasComeBack) {
  run("key 3\nframes 3\n");
  EXPECT_NEAR(view().into_view.y, -1, 1e-9);
  const Image from_y = picture();
  run("view.save_camera from y\nview.from -z\nview.orthographic on\nframes 3\n");
  EXPECT_NEAR(view().into_view.z, 1, 1e-9);
  EXPECT_GT(differing_pixels(picture(), from_y), 1000);
  run("view.camera \"from y\"\nwait-idle\n");
  EXPECT_EQ(differing_pixels(picture(), from_y), 0);
  ASSERT_EQ(viewer_->state().settings.views.size(), 1u);
  run("view.save_camera from y\nframes 2\n");  // replaces the camera of that name
  ASSERT_EQ(viewer_->state().settings.views.size(), 1u);
  run("view.forget_camera \"from y\"\nframes 2\n");
  EXPECT_TRUE(viewer_->state().settings.views.empty());
  EXPECT_NE(viewer_->commands().run_line("view.camera \"from y\"").why, "");
  undo();
  EXPECT_EQ(viewer_->state().settings.views.size(), 1u);
}

}  // namespace
}  // namespace alphascope::testing
