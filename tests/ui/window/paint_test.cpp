// SPDX-License-Identifier: GPL-3.0-or-later
// Tests colours in the whole window: schemes, legends, ranges, commands, sessions and the command
// line.
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class PaintTest : public ViewerTest {
 protected:
  DisplaySettings& display() { return viewer_->state().settings.display; }
  const ViewportInfo& viewport() { return viewer_->state().viewport; }
  const std::vector<ColourLegend>& legends() { return viewport().legends; }
  std::string refusal(const std::string& line) { return viewer_->commands().run_line(line).why; }
};

TEST_F(PaintTest, EverySchemeOfBallsDrawsAndSaysWhatItMeans) {
  open_crambin();
  display().tetrahedra = false;
  Image last = picture();
  for (const SchemeInfo& scheme : all_schemes()) {
    if (!scheme.balls || scheme.by == ColourBy::element) continue;
    run("view.colour_balls " + std::string(scheme.id) + "\nwait-idle\n");
    const Image now = picture();
    EXPECT_GT(differing_pixels(last, now), 200) << scheme.id;
    EXPECT_EQ(viewport().not_drawn, "") << scheme.id;
    last = now;
    if (scheme.by == ColourBy::single) {
      EXPECT_TRUE(legends().empty());
      continue;
    }
    ASSERT_EQ(legends().size(), 1u) << scheme.id;
    EXPECT_EQ(legends()[0].stops.empty(), !scheme.quantity) << scheme.id;
  }
  EXPECT_EQ(viewer_->state().undo_text, "colours of balls");
  run("edit.undo\nwait-idle\n");
  EXPECT_EQ(legends().size(), 1u);
}

TEST_F(PaintTest, EverySchemeOfSimplicesDrawsAndSaysWhatItMeans) {
  open_crambin();
  run("alpha.set -1.4\nview.colour_balls single\nview.triangles on\nview.edges on\nwait-idle\n");
  display().balls = false;
  Image last = picture();
  for (const SchemeInfo& scheme : all_schemes()) {
    if (!scheme.simplices || scheme.by == ColourBy::element) continue;
    run("view.colour_simplices " + std::string(scheme.id) + "\nwait-idle\n");
    const Image now = picture();
    EXPECT_GT(differing_pixels(last, now), 50) << scheme.id;
    last = now;
    EXPECT_EQ(legends().size(), scheme.by == ColourBy::single ? 0u : 1u) << scheme.id;
  }
  run("view.colour_simplices #ff0000\nwait-idle\n");
  EXPECT_GT(differing_pixels(last, picture()), 50);
}

TEST_F(PaintTest, ARangeIsTypedKeptAndTakenBack) {
  open_crambin();
  run("view.colour_balls b_factor\nwait-idle\n");
  const ColourRange automatic = viewport().ball_range.value();
  const Image before = picture();
  run("click display.ball_range.high\nkey ctrl+a\ntype 12\nkey enter\nwait-idle\nframes 3\n");
  ASSERT_TRUE(display().ball_paint.range);
  EXPECT_EQ(*display().ball_paint.range, (ColourRange{automatic.low, 12}));
  EXPECT_EQ(legends()[0].stops.back().value, 12);
  EXPECT_GT(differing_pixels(before, picture()), 200);
  run("click display.ball_range.auto\nwait-idle\nframes 3\n");
  EXPECT_FALSE(display().ball_paint.range);
  EXPECT_EQ(viewport().ball_range, automatic);
}

TEST_F(PaintTest, TwoQuantitiesHaveTwoLegends) {
  open_crambin();
  run("alpha.set 3\nview.colour_balls b_factor,cividis,0:20\n"
      "view.colour_simplices alpha,blue_white_red,-2:4\nwait-idle\n");
  ASSERT_EQ(legends().size(), 2u);
  EXPECT_EQ(legends()[0].title, "balls: B factor (Å²)");
  EXPECT_EQ(legends()[1].title, "simplices: alpha value (Å²), square-root scale");
  EXPECT_EQ(legends()[1].stops.front().value, -2);
  EXPECT_EQ(legends()[1].stops.back().value, 4);
}

TEST_F(PaintTest, ColoursOfOnesOwnStayOnTop) {
  open_crambin();
  display().tetrahedra = false;
  run("atoms.colour #ff00ff all\nwait-idle\n");
  const Image own = picture();
  for (const char* paint : {"b_factor", "chain", "exposed", "#00ff00"}) {
    run("view.colour_balls " + std::string(paint) + "\nwait-idle\n");
    EXPECT_EQ(differing_pixels(own, picture()), 0) << paint;
  }
}

TEST_F(PaintTest, AFormerNameOfASchemeIsReadAndTold) {
  open_crambin();
  run("view.colour_balls residue_kind\n");
  EXPECT_EQ(display().ball_paint.by, ColourBy::residue_class);
  EXPECT_NE(viewer_->state().notice.text().find("is called \"residue_class\" now"),
            std::string::npos);
}

TEST_F(PaintTest, WhatCannotBeIsSaid) {
  open_crambin();
  EXPECT_NE(refusal("view.colour_balls green").find("\"green\" is not a colour scheme of balls"),
            std::string::npos);
  EXPECT_NE(refusal("view.colour_simplices b_factor").find("simplices"), std::string::npos);
  std::ofstream(folder_ / "a.xyz") << "2\n\nC 0 0 0\nO 1.2 0 0\n";
  run("open " + (folder_ / "a.xyz").string() +
      "\nwait-idle\nview.colour_balls b_factor\nwait-idle\n");
  EXPECT_EQ(viewport().not_drawn, "The file gives no B factors, so all balls are grey.");
}

TEST_F(PaintTest, SessionsAndTheCommandLineHaveTheSame) {
  open_crambin();
  run("alpha.set 3\nview.colour_balls b_factor,cividis,0:20\nview.colour_simplices component\n"
      "view.triangles on\nview.edges on\nwait-idle\n");
  DisplaySettings& d = display();
  const DisplaySettings usual;  // as on the command line
  d.ambient_occlusion = usual.ambient_occlusion;
  d.depth_cue = usual.depth_cue;
  d.outlines = usual.outlines;
  d.samples = 4;
  const Paint balls = d.ball_paint, simplices = d.complex_paint;
  run("wait-idle\n");
  viewer_->calls().jobs.save_picture(ScreenshotRequest{folder_ / "window.png", {480, 320}});
  run("wait-idle\n");
  const Image window = pixels_of(folder_ / "window.png");
  const auto drawn = [&](const std::string& options) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + options +
                                " --size 480x320 -o " + (folder_ / "cli.png").string() +
                                " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return pixels_of(folder_ / "cli.png");
  };
  const std::string at_3 = crambin().string() + " --alpha 3 --samples 4 --colours ";
  EXPECT_LE(share_unlike(window, drawn(at_3 + "b_factor,cividis,0:20 --simplex-colours component")),
            0.001);
  EXPECT_GT(share_unlike(window, drawn(at_3 + "b_factor --simplex-colours component")), 0.003);
  const std::string session = (folder_ / "paint.json").string();
  run("file.save_session " + session + "\nwait-idle\n");
  EXPECT_LE(share_unlike(window, drawn("--session " + session)), 0.001);
  run("view.colour_balls chain\nview.colour_simplices class\nwait-idle\nopen " + session +
      "\nwait-idle\n");
  EXPECT_EQ(display().ball_paint, balls);
  EXPECT_EQ(display().complex_paint, simplices);
}

}  // namespace
}  // namespace alphascope::testing
