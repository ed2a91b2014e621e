// SPDX-License-Identifier: GPL-3.0-or-later
// Tests hidden atoms and own colours in the whole window. Nothing is computed again, and the window
// says what is missing. Undo, sessions and the command line keep them.
#include "core/triangulation/outer_faces.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/mesh/visible_mesh.hpp"

namespace alphascope::testing {
namespace {

class AppearanceTest : public ViewerTest {
 protected:
  void hide_half() { run("atoms.hide resi 1-20\nwait-idle\nframes 3\n"); }
  std::size_t hidden() { return viewer_->state().viewport.hidden_balls; }
};

TEST_F(AppearanceTest, HiddenAtomsLeaveThePictureAndComeBack) {
  open_crambin();
  run("alpha.set 3\nwait-idle\n");
  const Image whole = picture();
  const auto result = viewer_->state().result;
  EXPECT_EQ(hidden(), 0u);
  hide_half();
  EXPECT_GT(hidden(), 100u);
  const Image half = picture();
  EXPECT_GT(differing_pixels(whole, half), 2000);
  EXPECT_EQ(viewer_->state().result, result) << "nothing is computed anew";
  EXPECT_EQ(viewer_->state().undo_text, "hidden atoms");
  ASSERT_TRUE(viewer_->widgets().contains("view.show_hidden"));
  run("click view.show_hidden\nwait-idle\nframes 3\n");
  EXPECT_EQ(hidden(), 0u);
  EXPECT_FALSE(viewer_->widgets().contains("view.show_hidden"));
  EXPECT_EQ(differing_pixels(whole, picture()), 0);
  run("edit.undo\nwait-idle\nframes 3\n");
  EXPECT_EQ(differing_pixels(half, picture()), 0);
  run("open " + crambin().string() + "\nwait-idle\n");
  EXPECT_EQ(hidden(), 0u) << "another file is shown whole";
}

TEST_F(AppearanceTest, OnlyAndColoursActOnTheSelectionOrOnNames) {
  open_crambin();
  EXPECT_EQ(viewer_->commands().run_line("atoms.only").why,
            "Nothing of this molecule is selected. Select atoms, or name them.");
  EXPECT_EQ(viewer_->commands().run_line("atoms.colour reddish all").why,
            "\"reddish\" is not a colour. Write one such as #ff8800 or #f80.");
  EXPECT_EQ(viewer_->commands().run_line("atoms.hide chain Z").why,
            "The molecule has no atom of this name.");
  run("select.atoms backbone\natoms.only\nwait-idle\nframes 3\n");
  const std::size_t rest = hidden();
  EXPECT_GT(rest, 100u);
  run("atoms.hide not backbone\nwait-idle\nframes 3\n");
  EXPECT_EQ(hidden(), rest);
  const Image plain = picture();
  run("atoms.colour #ff00ff element N\nwait-idle\nframes 3\n");
  EXPECT_GT(differing_pixels(plain, picture()), 200);
  run("atoms.usual_colour all\nwait-idle\nframes 3\n");
  EXPECT_EQ(differing_pixels(plain, picture()), 0);
}

TEST_F(AppearanceTest, SavedPicturesSessionsAndTheCommandLineShowTheSame) {
  open_crambin();
  run("alpha.set 3\nview.triangles on\nview.edges on\nview.clip x=9.5\n");
  hide_half();
  run("atoms.colour #ff00ff element O\nwait-idle\n");
  DisplaySettings& display = viewer_->state().settings.display;
  const DisplaySettings usual;  // as on the command line
  display.ambient_occlusion = usual.ambient_occlusion;
  display.depth_cue = usual.depth_cue;
  display.outlines = usual.outlines;
  display.samples = 4;
  run("frames 3\nwait-idle\n");
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "window.png", {.width = 400, .height = 300}});
  run("wait-idle\n");
  const Image window = pixels_of(folder_ / "window.png");
  const auto drawn = [&](const std::string& options) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + options +
                                " --size 400x300 -o " + (folder_ / "cli.png").string() +
                                " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return pixels_of(folder_ / "cli.png");
  };
  const std::string crambin_at_3 = crambin().string() + " --alpha 3 --clip x=9.5 --samples 4 ";
  const std::string hide = "--hide \"resi 1-20\"", colours = " --atom-colours \"element O=#f0f\"";
  EXPECT_LE(share_unlike(window, drawn(crambin_at_3 + hide + colours)), 0.001);
  EXPECT_GT(share_unlike(window, drawn(crambin_at_3 + hide)), 0.003);
  EXPECT_GT(share_unlike(window, drawn(crambin_at_3 + colours)), 0.01);
  const std::string session = (folder_ / "hidden.json").string();
  run("file.save_session " + session + "\nwait-idle\n");
  EXPECT_LE(share_unlike(window, drawn("--session " + session)), 0.001);
}

// Compares with a check of every simplex by itself.
TEST(VisibleMesh, HasTheSimplicesWithoutHiddenCornersAndNamesThem) {
  AlphaComplex complex;
  complex.tetrahedra.simplices = {{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}};
  complex.tetrahedra.alpha_values = {1, 2, 3};
  complex.edges.simplices = {{0, 1}, {1, 4}, {3, 5}};
  complex.edges.alpha_values = {4, 5, 6};
  const std::vector<bool> hidden{true, false, false, false, false, false};
  const ComplexMesh mesh = build_visible_mesh(complex, hidden, [&](const AlphaComplex& part) {
    EXPECT_EQ(part.tetrahedra.simplices, (Simplices<4>{{1, 2, 3, 4}, {2, 3, 4, 5}}));
    EXPECT_EQ(part.edges.alpha_values, (ResultArray<float>{5, 6}));
    ComplexMesh of;
    of.outside.source = {face_code(1, 2), face_code(0, 3)};
    of.outside.faces.resize(2);
    of.tetrahedra.balls.resize(2);
    of.edges.edges.resize(2);
    return of;
  });
  EXPECT_EQ(mesh.outside.source, (ResultArray<std::uint32_t>{face_code(2, 2), face_code(1, 3)}));
  EXPECT_EQ(mesh.tetrahedra.source, (ResultArray<std::uint32_t>{1, 2}));
  EXPECT_EQ(mesh.edges.source, (ResultArray<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace alphascope::testing
