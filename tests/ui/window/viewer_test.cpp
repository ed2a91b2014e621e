// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the whole window in process, without a display: opening, sliding, looking at pixels.
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "app/options/exit_code.hpp"
#include "app/viewer/options.hpp"
#include "app/viewer/session_text.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using testing::crambin;
using testing::differing_pixels;
using testing::drawn_pixels;
using testing::texts_of;
using testing::unequal_pixels;
using testing::ViewerTest;

TEST_F(ViewerTest, OpensAndShowsTheComplex) {
  open_crambin();
  const auto& r = viewer_->state().result;
  ASSERT_TRUE(r);
  EXPECT_EQ(viewer_->state().molecule.balls, 327u);
  EXPECT_EQ(hash_text(r->complex.hash), hash_text(expected(0).hash));
  const Image scene = picture();
  EXPECT_GT(drawn_pixels(scene), scene.width * scene.height / 20);
}

TEST_F(ViewerTest, OfTwoDroppedFilesBothAreTold) {
  viewer_->open_dropped({folder_ / "notes.txt", crambin()});
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().molecule.name, "1crn.pdb");
  EXPECT_NE(viewer_->state().drop_note.find("Not opened: notes.txt"), std::string::npos);
  run("click view.dropped.ok\n");
  EXPECT_TRUE(viewer_->state().drop_note.empty());
}

TEST_F(ViewerTest, ADroppedFileThatCannotBeReadIsNotToldAsOpened) {
  open_crambin();
  std::ofstream(folder_ / "empty.pdb") << "HEADER\n";
  viewer_->open_dropped({folder_ / "empty.pdb", folder_ / "other.pdb"});
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().molecule.name, "1crn.pdb");
  EXPECT_TRUE(viewer_->state().drop_note.empty());
  EXPECT_NE(viewer_->state().error.find("Not opened: other.pdb"), std::string::npos);
}

TEST_F(ViewerTest, ADroppedFileIsTheAnswerToTheDialogThatAsksForOneAndToNoOther) {
  BrowserState& memory = viewer_->state().browser;
  for (const BrowserPurpose purpose : {BrowserPurpose::molecule, BrowserPurpose::save}) {
    memory.folder = folder_;
    memory.purpose = purpose;
    memory.show = true;
    viewer_->open_dropped({crambin()});
    run("wait-idle\n");
    const bool asks = purpose == BrowserPurpose::molecule;
    EXPECT_EQ(memory.show, !asks);
    EXPECT_EQ(memory.folder, asks ? crambin().parent_path() : folder_);
  }
}

TEST_F(ViewerTest, SlidingChangesComplexAndPicture) {
  open_crambin();
  const Image before = picture();
  run("click alpha.preset.3\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().result->request.alpha_angstrom2, 3);
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(3).hash));
  EXPECT_GT(differing_pixels(before, picture()), 5000);
  run("click alpha.preset.0\nwait-idle\n");
  EXPECT_EQ(differing_pixels(before, picture()), 0);
}

TEST_F(ViewerTest, SliderStormEndsAtTheLastAlpha) {
  open_crambin();
  std::string moves;
  for (int i = 0; i < 200; ++i) {
    moves += "move alpha.slider " + std::to_string(0.1 + 0.8 * ((i * 37) % 100) / 100) + " 0.5\n";
  }
  run("move alpha.slider 0.1 0.5\ndown\n" + moves + "move alpha.slider 0.45 0.5\nup\nwait-idle\n");
  const ViewState& s = viewer_->state();
  EXPECT_DOUBLE_EQ(s.result->request.alpha_angstrom2, s.settings.request.alpha_angstrom2);
  EXPECT_EQ(hash_text(s.result->complex.hash),
            hash_text(expected(s.settings.request.alpha_angstrom2).hash));
  EXPECT_TRUE(s.error.empty()) << s.error;
}

TEST_F(ViewerTest, PlayingLetsAlphaGrowUntilStopped) {
  open_crambin();
  run("click alpha.play\nframes 60\nclick alpha.play\nwait-idle\n");
  const ViewState& s = viewer_->state();
  EXPECT_FALSE(s.playback.alpha);
  EXPECT_GT(s.settings.request.alpha_angstrom2, 0.04);
  EXPECT_DOUBLE_EQ(s.result->request.alpha_angstrom2, s.settings.request.alpha_angstrom2);
  EXPECT_EQ(hash_text(s.result->complex.hash),
            hash_text(expected(s.settings.request.alpha_angstrom2).hash));
}

TEST_F(ViewerTest, SolventAndTetrahedraOnly) {
  open_crambin();
  run("click alpha.water\nwait-idle\n");
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(0, 1.4).hash));
  run("click engine.tetrahedra_only\nwait-idle\n");
  EXPECT_TRUE(viewer_->state().result->complex.tetrahedra_only);
  EXPECT_EQ(viewer_->state().result->complex.tetrahedra.size(), expected(0, 1.4).tetrahedra.size());
}

TEST_F(ViewerTest, ComparingGivesTheBadge) {
  open_crambin();
  EXPECT_EQ(viewer_->state().badge.state, BadgeInfo::State::not_compared);
  run("click bottom.timings\nclick timings.compare\nwait-idle\n");
  const BadgeInfo& badge = viewer_->state().badge;
  EXPECT_EQ(badge.state, BadgeInfo::State::identical);
  const std::string n = std::to_string(viewer_->state().result->complex.tetrahedra.size());
  EXPECT_EQ(badge.text, "identical to CGAL: " + n + " of " + n + " tetrahedra");
  EXPECT_TRUE(viewer_->state().cgal.any());
  run("click alpha.preset.10\nwait-idle\n");
  EXPECT_EQ(badge.state, BadgeInfo::State::not_compared);  // it is of another alpha
}

TEST_F(ViewerTest, AColdTimeIsMeasuredWhenAskedFor) {
  open_crambin();
  ViewState& s = viewer_->state();
  for (const auto engine : {EngineChoice::cgal, EngineChoice::automatic}) {
    s.settings.request.engine = engine;
    run("frames 1\nwait-idle\n");
  }
  ASSERT_TRUE(s.ours.any());
  ASSERT_FALSE(s.ours.cold) << "the engine was kept";
  run("click bottom.timings\nclick timings.run.0\nclick timings.compute_anew\nwait-idle\n");
  EXPECT_TRUE(s.ours.cold);
  EXPECT_TRUE(s.ours.warm);
}

TEST_F(ViewerTest, ABadFileKeepsTheMoleculeAndSaysWhy) {
  open_crambin();
  const std::string hash = hash_text(viewer_->state().result->complex.hash);
  const fs::path bad = folder_ / "bad.pdb";
  std::ofstream(bad) << "ATOM      1  CA  ALA A   1      nonsense\n";
  run("open " + bad.string() + "\nwait-idle\n");
  EXPECT_NE(viewer_->state().error.find("bad.pdb, line 1"), std::string::npos)
      << viewer_->state().error;
  EXPECT_EQ(viewer_->state().molecule.name, "1crn.pdb");
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash);
  run("click error.ok\n");
  EXPECT_TRUE(viewer_->state().error.empty());
}

TEST_F(ViewerTest, EveryDisplaySwitchDraws) {
  open_crambin();
  run("click alpha.preset.1.4\nwait-idle\n");
  DisplaySettings& d = viewer_->state().settings.display;
  const DisplaySettings usual = d;
  struct Switch {
    const char* name;
    std::function<void(DisplaySettings&)> before, change;
  };
  const auto nothing = [](DisplaySettings&) {};
  const auto no_tetrahedra = [](DisplaySettings& c) { c.tetrahedra = false; };
  const auto edges = [](DisplaySettings& c) { c.tetrahedra = c.balls = false, c.edges = true; };
  const std::vector<Switch> switches{
      {"balls", nothing, [](auto& c) { c.balls = false; }},
      {"ball size", nothing, [](auto& c) { c.ball_scale = 0.6f; }},
      {"grown", nothing, [](auto& c) { c.grown_balls = true; }},
      {"ball opacity", nothing, [](auto& c) { c.ball_opacity = 0.3f; }},
      {"ball colour", nothing, [](auto& c) { c.ball_paint.by = ColourBy::single; }},
      {"tetrahedra", nothing, [](auto& c) { c.tetrahedra = false; }},
      {"shrink", nothing, [](auto& c) { c.shrink = 0.3f; }},
      {"boundary", no_tetrahedra, [](auto& c) { c.boundary = true; }},
      {"triangles", no_tetrahedra, [](auto& c) { c.triangles = true; }},
      {"edges", no_tetrahedra, [](auto& c) { c.edges = true; }},
      {"singular only", edges, [](auto& c) { c.singular_only = false; }},
      {"opacity", nothing, [](auto& c) { c.complex_opacity = 0.4f; }},
      {"colour", nothing, [](auto& c) { c.complex_paint.by = ColourBy::alpha; }},
      {"soft shadows", nothing, [](auto& c) { c.ambient_occlusion = true; }},
      {"strength of shadows", [](auto& c) { c.ambient_occlusion = true; },
       [](auto& c) { c.shadow_strength = 0.3f; }},
      {"depth cue", nothing, [](auto& c) { c.depth_cue = 0.8f; }},
      {"outlines", nothing, [](auto& c) { c.outlines = 3; }}};
  for (const auto& [name, before, change] : switches) {
    d = usual;
    before(d);
    const Image without = picture();
    change(d);
    EXPECT_GT(differing_pixels(without, picture()), 200) << name << " changed nothing";
  }
  d = usual;
  const Image dark = picture();
  viewer_->state().window.theme = Theme::light;
  const Image light = picture();
  EXPECT_LT(dark.rgba[0], 60);
  EXPECT_GT(light.rgba[0], 200);
}

TEST_F(ViewerTest, ColoursByAlphaHaveALegend) {
  open_crambin();
  run("click alpha.preset.3\nwait-idle\n");
  const std::vector<ColourLegend>& legends = viewer_->state().viewport.legends;
  ASSERT_EQ(legends.size(), 1u) << "of balls and simplices alike";
  EXPECT_EQ(legends[0].title, "element");
  EXPECT_EQ(legends[0].entries.size(), 4u);
  run("click display.complex_colour\nclick display.complex_colour.3\nwait-idle\n");
  ASSERT_EQ(legends.size(), 2u);
  EXPECT_EQ(legends[0].title, "balls: element");
  EXPECT_EQ(legends[1].title, "simplices: alpha value (Å²), square-root scale");
  EXPECT_DOUBLE_EQ(legends[1].stops.back().value, 3);
  EXPECT_LT(legends[1].stops.front().value, 0);
  const WidgetRects& widgets = viewer_->widgets();
  ASSERT_TRUE(widgets.contains("view.legend"));
  EXPECT_GE(widgets.at("view.legend").x0, widgets.at("view").x0);
  EXPECT_LE(widgets.at("view.legend").y1, widgets.at("view").y1);
  run("click alpha.preset.1.4\nwait-idle\n");
  EXPECT_DOUBLE_EQ(legends[1].stops.back().value, 1.4) << "it follows alpha";
  run("click display.tetrahedra\nwait-idle\n");
  ASSERT_EQ(legends.size(), 1u) << "nothing is drawn in these colours";
  EXPECT_EQ(legends[0].title, "element");
  run("click display.balls\nwait-idle\n");
  EXPECT_TRUE(legends.empty());
}

TEST_F(ViewerTest, SavesAPictureOfTheChosenSize) {
  open_crambin();
  viewer_->calls().jobs.save_picture(ScreenshotRequest{
      folder_ / "picture.png", {.width = 320, .height = 240, .background = kNoBackground}});
  run("wait-idle\n");
  EXPECT_TRUE(viewer_->state().error.empty()) << viewer_->state().error;
  EXPECT_EQ(viewer_->state().notice.text(), "Saved " + (folder_ / "picture.png").string());
  const Image saved = testing::pixels_of(folder_ / "picture.png");
  EXPECT_EQ(saved.width, 320);
  EXPECT_EQ(saved.height, 240);
  EXPECT_GT(drawn_pixels(saved), 320 * 240 / 20);
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{"/no/such/folder/picture.png", {.width = 320, .height = 240}});
  run("wait-idle\n");
  EXPECT_NE(viewer_->state().error.find("/no/such/folder"), std::string::npos);
}

// Compares one view, as the window's scene draws it and as the background thread's scene does.
TEST_F(ViewerTest, ASavedPictureIsWhatTheViewShows) {
  open_crambin();
  run("click alpha.preset.3\nmove view 0.3 0.4\ndown\nmove view 0.6 0.5\nup\n");
  DisplaySettings& d = viewer_->state().settings.display;
  for (const DisplayPreset preset : {DisplayPreset::teaching, DisplayPreset::cavity}) {
    d = with_preset(d, preset);
    d.samples = 3;
    const Image shown = testing::upright(picture());
    const ViewportInfo& v = viewer_->state().viewport;
    viewer_->calls().jobs.save_picture(ScreenshotRequest{
        folder_ / "picture.png", {.width = v.width, .height = v.height, .legend = false}});
    run("wait-idle\n");
    const Image saved = testing::pixels_of(folder_ / "picture.png");
    ASSERT_EQ(saved.width, shown.width);
    EXPECT_LE(unequal_pixels(saved, shown), shown.width * shown.height / 1000);
  }
}

// A long molecule fills the wide view. A square picture of it is not cut off at its sides.
TEST_F(ViewerTest, ANarrowerPictureShowsAllThatTheViewShows) {
  constexpr int kBalls = 30;
  std::ofstream file(folder_ / "long.xyzr");
  for (int n = 0; n < kBalls; ++n) file << 2 * n << " 0 0 0.5\n";
  file.close();
  run("open " + (folder_ / "long.xyzr").string() +
      "\nwait-idle\nview.from z\nview.reset\nwait-idle\n");
  EXPECT_GT(drawn_pixels(picture()), 200);
  const auto balls_in_picture = [&](int width) {
    viewer_->calls().jobs.save_picture(ScreenshotRequest{
        folder_ / "p.png",
        {.width = width, .height = 600, .background = kNoBackground, .legend = false}});
    run("wait-idle\n");
    const Image image = testing::pixels_of(folder_ / "p.png");
    int balls = 0;
    bool inside = false;
    for (int x = 0; x < image.width; ++x) {
      bool drawn = false;
      for (int y = 0; y < image.height; ++y) {
        drawn |= image.rgba[4 * (std::size_t(y) * image.width + x) + 3] > 0;
      }
      balls += drawn && !inside;
      inside = drawn;
    }
    return balls;
  };
  EXPECT_EQ(balls_in_picture(1200), kBalls);
  EXPECT_EQ(balls_in_picture(600), kBalls);
}

// Values that nobody has changed reach the scene as well.
TEST_F(ViewerTest, AWindowWithoutOptionsDrawsAsItsPanelSays) {
  viewer_.reset();
  ViewerOptions options;
  options.compare = false;
  options.draw_shots_only = true;
  viewer_ = std::make_unique<Viewer>(*host_, options);
  run("size 640 480\n");
  open_crambin();
  const Image with = picture();
  viewer_->state().settings.display.outlines = 0;
  EXPECT_GT(unequal_pixels(with, picture()), 500) << "outlines were drawn";
}

TEST_F(ViewerTest, PicturesGetFinerAtRest) {
  open_crambin();
  DisplaySettings& d = viewer_->state().settings.display;
  d = with_preset(d, DisplayPreset::teaching);
  d.samples = 3;
  const Image fine = picture();
  const auto is_fine = [&] {
    const Image shown =
        testing::texture_pixels(static_cast<unsigned>(viewer_->state().viewport.texture));
    return shown.width == fine.width && unequal_pixels(shown, fine) == 0;
  };
  const DisplaySettings before = d;
  d.depth_cue = 1;
  run("frames 1\n");
  d = before;
  run("frames 1\n");
  EXPECT_FALSE(is_fine());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  bool at_last = false;
  while (!at_last && std::chrono::steady_clock::now() < deadline) {
    run("frames 1\n");
    at_last = is_fine();
  }
  EXPECT_TRUE(at_last) << "by itself, as fine as in a file";
}

TEST_F(ViewerTest, TheWindowGoesOnWhileAPictureIsSaved) {
  open_crambin();
  const auto save = [this] {
    viewer_->calls().jobs.save_picture(
        ScreenshotRequest{folder_ / "picture.png", {.width = 3000, .height = 2000}});
    run("frames 1\n");
  };
  save();
  ASSERT_NE(file_job(viewer_->state().jobs), nullptr);
  EXPECT_EQ(file_job(viewer_->state().jobs)->title, "Saving picture.png");
  run("frames 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("view.cancel_save"));
  save();  // one at a time
  EXPECT_NE(viewer_->state().error.find("still being saved"), std::string::npos)
      << viewer_->state().error;
  viewer_->state().error.clear();
  run("wait-idle\n");
  EXPECT_EQ(file_job(viewer_->state().jobs), nullptr);
  EXPECT_TRUE(fs::exists(folder_ / "picture.png"));
}

TEST_F(ViewerTest, ACancelledPictureLeavesTheOldFile) {
  open_crambin();
  std::ofstream(folder_ / "picture.png") << "older";
  viewer_->state().settings.display.samples = 16;  // else it may be done before the click
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "picture.png", {.width = 3000, .height = 2000}});
  run("frames 3\nclick view.cancel_save\nframes 2\n");
  EXPECT_EQ(file_job(viewer_->state().jobs), nullptr) << "at once";
  EXPECT_NE(viewer_->state().notice.text().find("was not written"), std::string::npos);
  EXPECT_EQ(bytes("picture.png"), "older");
  // The next picture waits for the last one.
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "other.png", {.width = 100, .height = 100}});
  run("wait-idle\n");
  EXPECT_TRUE(viewer_->state().error.empty()) << viewer_->state().error;
  EXPECT_TRUE(fs::exists(folder_ / "other.png"));
  EXPECT_EQ(bytes("picture.png"), "older");
}

TEST_F(ViewerTest, AViewOfNothingSaysSoAndHasAWayBack) {
  open_crambin();
  viewer_->state().settings.display.ball_scale = 1;
  viewer_->state().settings.display.grown_balls = true;
  run("click alpha.preset.10\nwait-idle\n");
  for (int i = 0; i < 20 && viewer_->state().viewport.problem == ViewProblem::none; ++i) {
    run("move view 0.5 0.5\nwheel 10\n");
  }
  EXPECT_EQ(viewer_->state().viewport.problem, ViewProblem::inside_a_ball);
  run("frames 3\nclick view.show_all\nframes 3\n");
  EXPECT_EQ(viewer_->state().viewport.problem, ViewProblem::none);
  EXPECT_FALSE(viewer_->widgets().contains("view.trouble"));
}

// The camera is close to the middle of the balls. Another selection may have a ball around it, and
// is then fitted into the view.
TEST_F(ViewerTest, ASelectionAroundTheCameraIsFitted) {
  open_crambin();
  viewer_->state().settings.display.ball_scale = 0.05f;
  run("move view 0.5 0.5\nframes 3\nwheel 10\nwheel 10\nwheel 10\nwheel 10\nwait-idle\n");
  ASSERT_EQ(viewer_->state().viewport.problem, ViewProblem::none);
  const double close = viewer_->state().viewport.angstrom_per_pixel;
  run("click molecule.expression\ntype resi 1-40\nkey enter\nwait-idle\n");
  // Texts beside the view may make it a row of pixels higher. A wrong camera would be off by a
  // factor of 100.
  EXPECT_NEAR(viewer_->state().viewport.angstrom_per_pixel, close, 0.01 * close)
      << "nothing in the way";
  viewer_->state().settings.display.ball_scale = 1;
  run("click molecule.expression\nkey ctrl+a\ntype resi 7 and name CA\nkey enter\nwait-idle\n");
  EXPECT_EQ(viewer_->state().molecule.balls, 1u);
  EXPECT_GT(viewer_->state().viewport.angstrom_per_pixel, close);
  EXPECT_EQ(viewer_->state().viewport.problem, ViewProblem::none);
}

// Counts rows of a picture of 960 x 600 pixels in which every colour of the legend is in its place.
int rows_with_legend(const Image& image, const ColourLegend& legend) {
  int rows = 0;
  for (int y = 0; y < image.height; ++y) {
    bool all = true;
    for (std::size_t i = 1; i + 1 < legend.stops.size(); ++i) {
      const std::size_t x = 20 + 180 * i / (legend.stops.size() - 1);
      const std::uint8_t* p = &image.rgba[4 * (std::size_t(y) * image.width + x)];
      const Colour& c = legend.stops[i].colour;
      all = all && std::abs(p[0] - c.r * 255) < 6 && std::abs(p[1] - c.g * 255) < 6 &&
            std::abs(p[2] - c.b * 255) < 6;
    }
    rows += all;
  }
  return rows;
}

TEST_F(ViewerTest, PicturesHaveTheWindowsLegendUnlessOneSwitchesItOff) {
  open_crambin();
  run("click alpha.preset.3\nclick engine.tetrahedra_only\nclick display.complex_colour\n"
      "click display.complex_colour.3\nwait-idle\n");
  const ColourLegend legend = viewer_->state().viewport.legends.at(1);
  const auto saved = [&](bool with_legend) {
    viewer_->calls().jobs.save_picture(ScreenshotRequest{
        folder_ / "picture.png", {.width = 960, .height = 600, .legend = with_legend}});
    run("wait-idle\n");
    return testing::pixels_of(folder_ / "picture.png");
  };
  const auto drawn = [&](const std::string& options) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + crambin().string() +
                                " --alpha 3 --tetrahedra-only --simplex-colours alpha " + options +
                                " --size 960x600 -o " + (folder_ / "cli.png").string() +
                                " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return testing::pixels_of(folder_ / "cli.png");
  };
  const Image window = saved(true), command_line = drawn("");
  EXPECT_EQ(rows_with_legend(window, legend), 10);
  EXPECT_EQ(rows_with_legend(saved(false), legend), 0);
  EXPECT_EQ(rows_with_legend(drawn("--no-legend"), legend), 0);
  for (int y = 520; y < 600; ++y) {  // with the numbers
    const auto row = [y](const Image& image) { return image.rgba.begin() + 4L * y * image.width; };
    EXPECT_TRUE(std::equal(row(window), row(window) + 4 * 220, row(command_line))) << "row " << y;
  }
}

TEST_F(ViewerTest, PicturesTooSmallForALegendSaySo) {
  open_crambin();
  run("click display.complex_colour\nclick display.complex_colour.3\nwait-idle\n");
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "picture.png", {.width = 200, .height = 150}});
  run("wait-idle\n");
  EXPECT_NE(viewer_->state().notice.text().find("The picture has no legend"), std::string::npos)
      << viewer_->state().notice.text();
}

TEST_F(ViewerTest, APictureThatCannotBeWrittenLeavesTheViewAsItWas) {
  open_crambin();
  shot("before.png");
  const auto texture_width = [this] {
    GLint width = 0;
    glBindTexture(GL_TEXTURE_2D, viewer_->state().viewport.texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glBindTexture(GL_TEXTURE_2D, 0);
    return width;
  };
  const int before = texture_width();
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{"/no/such/folder/picture.png", {.width = 320, .height = 240}});
  run("wait-idle\nframes 2\nclick error.ok\nwait-idle\n");
  shot("after.png");
  EXPECT_EQ(texture_width(), before) << "it shows what was to be saved";
}

TEST_F(ViewerTest, PicturesSayWhereTheyComeFrom) {
  shot("empty.png");
  EXPECT_TRUE(texts_of(bytes("empty.png")).empty());
  open_crambin();
  run("click alpha.preset.1.4\nclick alpha.water\nwait-idle\n");
  viewer_->calls().jobs.save_picture(ScreenshotRequest{
      folder_ / "picture.png", {.width = 320, .height = 240, .background = kNoBackground}});
  run("wait-idle\n");
  ASSERT_TRUE(viewer_->state().error.empty()) << viewer_->state().error;
  const auto texts = texts_of(bytes("picture.png"));
  const auto text = [&texts](const std::string& key) {
    const auto found = texts.find(key);
    return found == texts.end() ? "(none)" : found->second;
  };
  EXPECT_EQ(text("Software").find("alphascope "), 0u) << text("Software");
  EXPECT_EQ(text("alphascope:file"), crambin().string());
  EXPECT_EQ(text("alphascope:sha256"), viewer_->session().state().molecule->sha256);
  EXPECT_EQ(text("alphascope:alpha_angstrom2"), "1.4");
  EXPECT_EQ(text("alphascope:solvent_radius_angstrom"), "1.4");
  EXPECT_EQ(text("alphascope:hash"), hash_text(expected(1.4, 1.4).hash));
  EXPECT_EQ(text("alphascope:radii").find("ProtOr"), 0u) << text("alphascope:radii");
  shot("window.png");  // the whole window has the same text
  EXPECT_EQ(texts_of(bytes("window.png")), texts);
}

TEST_F(ViewerTest, PicturesSayTheSameAsTheCommandLines) {
  open_crambin();
  run("click alpha.preset.3\nclick molecule.ligands\nwait-idle\nshot " +
      (folder_ / "window.png").string() + "\n");
  const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + crambin().string() +
                              " --alpha 3 --no-ligands --size 64x64 -o " +
                              (folder_ / "cli.png").string() + " > /dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  auto window = texts_of(bytes("window.png")), cli = texts_of(bytes("cli.png"));
  EXPECT_EQ(window["alphascope:options"], "--no-ligands");
  for (auto* texts : {&window, &cli}) {  // "alphascope 0.2.0 (…)" and "alphascope-cli 0.2.0 (…)"
    std::string& program = (*texts)["Software"];
    program.erase(0, program.find(' '));
    texts->erase("alphascope:note");  // this test is in no installation, so it finds no GPU library
  }
  EXPECT_EQ(cli.erase("alphascope:command"), 1u) << "which no picture of a window has";
  EXPECT_EQ(window, cli);
}

TEST_F(ViewerTest, ResizingIsFollowed) {
  open_crambin();
  run("size 1500 900\n");
  const ViewportInfo& view = viewer_->state().viewport;
  EXPECT_GT(view.width, 1100);
  const Image scene = picture();
  EXPECT_EQ(scene.width, view.width);
  EXPECT_EQ(scene.height, view.height);
  EXPECT_GT(drawn_pixels(scene), scene.width * scene.height / 20);
  shot("large.png");
  EXPECT_EQ(testing::pixels_of(folder_ / "large.png").width, 1500);
}

TEST_F(ViewerTest, ScriptsNameTheLineThatFails) {
  try {
    run("frames 1\n# a comment\n\nclick no.such.widget\n");
    FAIL() << "a widget that does not exist was clicked";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "test, line 4: there is no widget 'no.such.widget' on screen");
  }
}

TEST_F(ViewerTest, ScriptsDoSomethingOnlyWhenTheMoleculeHasIt) {
  open_crambin();  // it has no dropped atoms, one chain and an assembly
  run("when dropped\nclick no.such.widget\nend\nwhen chains\nquit\nend\n"
      "when assemblies\nclick alpha.preset.*\nend\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().result->request.alpha_angstrom2, 0);
  run("click alpha.preset.3*\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().result->request.alpha_angstrom2, 3);
  for (const char* wrong :
       {"when assemblies\nclick no.such.widget\nend\n", "when nonsense\nend\n", "end\n",
        "when dropped\n", "when dropped\nwhen chains\nend\nend\n", "click no.such.*\n"}) {
    EXPECT_THROW(run(wrong), std::runtime_error) << wrong;
  }
}

TEST(ViewerOptionsTest, ReadsEverything) {
  const char* argv[] = {"alphascope", "m.pdb",    "--alpha", "-0.5", "--solvent", "1.4",
                        "--size",     "1280x800", "--scale", "2",    "--shot",    "o.png"};
  const ParsedOptions parsed = parse_options(static_cast<int>(std::size(argv)), argv);
  ASSERT_FALSE(parsed.exit_code) << parsed.text;
  EXPECT_EQ(*parsed.options.file, "m.pdb");
  EXPECT_DOUBLE_EQ(parsed.options.alpha, -0.5);
  EXPECT_EQ(parsed.options.width, 1280);
  EXPECT_DOUBLE_EQ(parsed.options.scale, 2);
}

// The window's command lines in a text, behind four blanks or between backquotes. Words in capitals
// are replaced by a value.
std::vector<std::vector<std::string>> command_lines(const std::string& text) {
  std::vector<std::vector<std::string>> found;
  const std::regex line("(?:\\n    |`)alphascope ([^`\\n]*)");
  for (std::sregex_iterator m(text.begin(), text.end(), line), last; m != last; ++m) {
    found.push_back({"alphascope"});
    std::istringstream words((*m)[1]);
    for (std::string word; words >> word && word != "#" && word[0] != '(';) {
      if (word == "MB") word = "100";
      if (word == "FILE" && found.back().back() == "--script") word = "/dev/null";
      found.back().push_back(word);
    }
  }
  return found;
}

TEST(ViewerOptionsTest, CommandLinesOfTheGuideAreUnderstood) {
  const std::filesystem::path source = ALPHASCOPE_SOURCE_DIR;
  std::size_t lines = 0;
  std::vector<std::filesystem::path> names{source / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") names.push_back(entry.path());
  }
  for (const std::filesystem::path& name : names) {
    std::ostringstream text;
    text << std::ifstream(name).rdbuf();
    for (const std::vector<std::string>& words : command_lines(text.str())) {
      std::vector<const char*> argv;
      for (const std::string& word : words) argv.push_back(word.c_str());
      const ParsedOptions parsed = parse_options(static_cast<int>(argv.size()), argv.data());
      EXPECT_TRUE(!parsed.exit_code || *parsed.exit_code == 0) << name << ": " << parsed.text;
      ++lines;
    }
  }
  EXPECT_GE(lines, 12u);
}

TEST(ViewerOptionsTest, AnEmptyValueIsRefused) {
  for (const char* option : {"--session", "--alpha", "--size", "--preset", "--preferences",
                             "--lesson", "--record", "--script", "--shot"}) {
    const char* argv[] = {"alphascope", option, ""};
    const ParsedOptions parsed = parse_options(3, argv);
    ASSERT_TRUE(parsed.exit_code) << option;
    EXPECT_EQ(*parsed.exit_code, static_cast<int>(ExitCode::usage));
    EXPECT_NE(parsed.text.find("the value is empty"), parsed.text.npos) << parsed.text;
  }
}

TEST(ViewerOptionsTest, RefusesNonsenseWithAReason) {
  for (const char* bad : {"--alpha=nan", "--alpha=abc", "--size=12", "--size=1x1", "--solvent=-1",
                          "--scale=0", "--script=/no/such/file", "--what"}) {
    const char* argv[] = {"alphascope", bad};
    const ParsedOptions parsed = parse_options(2, argv);
    ASSERT_TRUE(parsed.exit_code) << bad;
    EXPECT_EQ(*parsed.exit_code, static_cast<int>(ExitCode::usage)) << bad;
    EXPECT_FALSE(parsed.text.empty()) << bad;
  }
}

TEST(StateBridge, SaysWhatDiffers) {
  auto agreement = std::make_shared<Agreement>();
  agreement->ours = std::make_shared<const Answer>();
  agreement->comparison.tetrahedra.missing = {{0, 1, 2, 3}};
  agreement->comparison.edges.extra = {{0, 1}, {0, 2}};
  SessionState state;
  state.ours = agreement->ours;
  state.agreement = agreement;
  const BadgeInfo badge = describe_agreement(state, state.ours.get(), false);
  EXPECT_EQ(badge.state, BadgeInfo::State::different);
  EXPECT_EQ(badge.text,
            "differs from CGAL: tetrahedra: 1 missing, 0 extra; edges: 0 missing, 2 extra");
}

}  // namespace
}  // namespace alphascope
