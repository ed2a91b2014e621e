// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the panels around the view: alpha, timings, dialogs, shortcuts.
#include <cmath>
#include <functional>
#include <future>

#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/colour_legend.hpp"
#include "ui/panels/complex/timings_state.hpp"
#include "ui/panels/complex/timings_text.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;
using testing::Size;

TEST(PanelsTest, EmptyWindowOffersToOpenSomething) {
  Panels p({1280, 800, 1});
  p.state.samples = {{"crambin", "1CRN", "1crn.pdb"}};
  p.frame(3);
  p.click("start.sample.0");
  // The request of an earlier frame stays until the program takes it.
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(*p.asked.open, "1crn.pdb");
  EXPECT_FALSE(p.rects.contains("timings.badge"));
}

TEST(PanelsTest, PresetsAndSliderChangeAlpha) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.click("alpha.preset.1.4");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.4);
  p.point_at("alpha.slider", 0.2f);
  p.press(true);
  const double low = p.state.settings.request.alpha_angstrom2;
  p.point_at("alpha.slider", 0.8f);
  const double high = p.state.settings.request.alpha_angstrom2;
  p.press(false);
  EXPECT_LT(low, 0.5);
  EXPECT_GT(high, 6);
  EXPECT_DOUBLE_EQ(high, std::round(high * 100) / 100);
}

TEST(PanelsTest, AlphaCanBeTyped) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.click("alpha.typed");
  ImGui::GetIO().KeyCtrl = true;
  p.tap(key::kA);
  ImGui::GetIO().KeyCtrl = false;
  ImGui::GetIO().AddInputCharactersUTF8("-2.25");
  p.frame(2);
  p.tap(key::kEnter);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, -2.25);
}

TEST(PanelsTest, WaterButtonTogglesTheSolvent) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.click("alpha.water");
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.4);
  p.click("alpha.water");
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 0);
}

TEST(PanelsTest, DraggingTheSliderNeverTurnsTheView) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.point_at("alpha.slider", 0.2f);
  p.press(true);
  p.point_at("view", 0.5f, 0.5f);  // the mouse leaves the slider with the button down
  EXPECT_TRUE(p.state.viewport.events.empty());
  p.press(false);
}

TEST(PanelsTest, DraggingInTheViewIsForwarded) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.point_at("view", 0.5f, 0.5f);
  ImGui::GetIO().MouseDown[0] = true;
  p.frame();
  ASSERT_EQ(p.state.viewport.events.size(), 2u);
  EXPECT_EQ(p.state.viewport.events[1].kind, PointerEvent::Kind::press);
  EXPECT_NEAR(p.state.viewport.events[1].x, p.state.viewport.width / 2, 2);
  ImGui::GetIO().MouseDown[0] = false;
  p.frame();
  ASSERT_EQ(p.state.viewport.events.size(), 2u);
  EXPECT_EQ(p.state.viewport.events[0].kind, PointerEvent::Kind::release);
  EXPECT_EQ(p.state.viewport.events[1].kind, PointerEvent::Kind::click) << "it did not move";
  ImGui::GetIO().MouseDown[0] = true;
  p.frame();
  p.point_at("view", 0.6f, 0.5f);
  p.point_at("view", 0.5f, 0.5f);
  ImGui::GetIO().MouseDown[0] = false;
  p.frame();
  ASSERT_FALSE(p.state.viewport.events.empty());
  EXPECT_EQ(p.state.viewport.events.back().kind, PointerEvent::Kind::release) << "a drag";
}

TEST(PanelsTest, ShortcutsWorkButNotWhileTyping) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.tap(key::kB);
  EXPECT_FALSE(p.state.settings.display.balls);
  p.click("alpha.typed");
  p.tap(key::kB);
  EXPECT_FALSE(p.state.settings.display.balls);
}

TEST(PanelsTest, ErrorIsShownUntilDismissed) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.error = "x.pdb, line 3: no number. Write one.";
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("error.ok"));
  p.click("error.ok");
  EXPECT_TRUE(p.state.error.empty());
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("error.ok"));
}

TEST(PanelsTest, LongWorkShowsProgressAndCancel) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.jobs = {{JobId::computing, "Computing", "kernel II", 0.4, 0.05}};
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("view.cancel"));  // too short to be shown without a flicker
  p.state.jobs[0].seconds = 1;
  p.frame(2);
  p.click("view.cancel");
  EXPECT_TRUE(p.asked.cancel);
}

TEST(PanelsTest, AViewWithoutAtomsSaysThatTheyAreHidden) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.viewport.problem = ViewProblem::nothing_in_view;
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("view.show_all"));
  p.state.viewport.hidden_balls = p.state.molecule.balls;
  p.state.viewport.problem = ViewProblem::all_hidden;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("view.show_all")) << "no view shows what is hidden";
  EXPECT_TRUE(p.rects.contains("view.show_hidden"));
}

TEST(PanelsTest, WorkOfUnknownLengthHasNoBarThatLooksLikeAShare) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.jobs = {{JobId::computing, "Computing", "", -1, 1.3}};
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("view.busy_bar"));
  p.state.jobs[0].share = 0.4;
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("view.busy_bar"));
}

// A run that prepares its data again is slower than one that reuses them, with any engine. So such
// runs are not compared.
TEST(PanelsTest, SpeedsOfDifferentWorkAreNotCompared) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.ours.warm = p.state.cgal.warm = p.state.ours.cold;
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("timings.speed"));
  p.state.ours.warm->rebuilt = true;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("timings.speed"));
  p.state.ours.warm->rebuilt = false;
  p.state.ours.warm->of_whole = p.state.cgal.warm->of_whole = true;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("timings.speed")) << "the same threshold twice";
}

TEST(PanelsTest, TheTimingsStayAsHighOnAnotherMonitor) {
  for (const float scale : {1.0f, 2.0f}) {
    Panels p({1280, 800, scale});
    p.state = loaded_state();
    p.state.window.page_height = 150;
    p.frame(2);
    EXPECT_FLOAT_EQ(p.rects["layout.splitter"].y0, (800 - 27 - 150) * scale) << scale;
    p.point_at("layout.splitter");
    p.press(true);
    ImGui::GetIO().MousePos.y -= 40 * scale;
    p.frame(2);
    p.press(false);
    EXPECT_NEAR(p.state.window.page_height, 190, 0.01) << scale;
  }
}

TEST(PanelsTest, TheLettersAreThereWithoutAnyInstalledFont) {
  ImGui::CreateContext();
  const PanelFonts fonts = load_fonts(1, "/nonexistent");
  for (const ImFont* font : {fonts.regular, fonts.strong, fonts.small, fonts.large, fonts.mono}) {
    for (const ImWchar letter : {0x3b1, 0x3c7, 0xc5, 0xb2, 0xb7, 0xd7, 0x2192, 0x2190, 0x2191,
                                 0x2193, 0x2212, 0x2026, 0x201c, 0x201d, 0x2013, 0x2260, 0x2713}) {
      EXPECT_NE(font->FindGlyphNoFallback(letter), nullptr) << std::hex << int{letter};
    }
  }
  ImGui::DestroyContext();
}

TEST(PanelsTest, FontsMadeByAThreadAreThoseOfTheWindow) {
  BuiltFonts built = std::async(std::launch::async, [] { return build_fonts(1.5f); }).get();
  ImGui::CreateContext();
  const PanelFonts fonts = load_fonts(1.5f);
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ASSERT_EQ(built.atlas->TexWidth, atlas.TexWidth);
  ASSERT_EQ(built.atlas->TexHeight, atlas.TexHeight);
  EXPECT_EQ(built.fonts.regular->FontSize, fonts.regular->FontSize);
  EXPECT_EQ(built.fonts.mono->CalcTextSizeA(18, 1e3f, 0, "hash").x,
            fonts.mono->CalcTextSizeA(18, 1e3f, 0, "hash").x);
  ImGui::DestroyContext();
  ImGui::CreateContext(built.atlas.get());
  ImGui::DestroyContext();
  EXPECT_TRUE(built.atlas->IsBuilt()) << "the context leaves it to its owner";
}

TEST(PanelsTest, MissingTimesSayWhyAndHowToGetThem) {
  WholeState s;
  ASSERT_EQ(missing_times(s, true).size(), 1u);
  EXPECT_NE(missing_times(s, true)[0].find("Open a molecule"), std::string::npos);
  s.molecule.loaded = true;
  EXPECT_EQ(missing_times(s, true)[0], "Nothing is computed yet: move alpha.");
  s.jobs = {{JobId::computing, "Computing"}};
  EXPECT_NE(missing_times(s, true)[0].find("when the computation is done"), std::string::npos);
  s = loaded_state();  // cold times of both engines, no warm ones
  EXPECT_TRUE(missing_times(s, true).empty());
  EXPECT_FALSE(lacks_cold_time(s));
  ASSERT_EQ(missing_times(s, false).size(), 2u);
  EXPECT_NE(missing_times(s, false)[0].find("Move alpha once more"), std::string::npos);
  s.ours.warm = s.ours.cold;
  s.cgal.warm.swap(s.cgal.cold);
  ASSERT_EQ(missing_times(s, true).size(), 1u);
  EXPECT_EQ(missing_times(s, true)[0].find("CGAL: no cold time"), 0u);
  EXPECT_TRUE(lacks_cold_time(s));
  EXPECT_TRUE(missing_times(s, false).empty());
  EXPECT_EQ(wall_text(s.cgal.cold), "not measured");
}

TEST(PanelsTest, ColdTimesThatAreMissingCanBeMeasured) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("timings.missing"));
  EXPECT_FALSE(p.rects.contains("timings.compute_anew"));
  p.state.ours.warm.swap(p.state.ours.cold);
  p.frame(2);
  p.click("timings.run.0");
  EXPECT_TRUE(p.rects.contains("timings.missing"));
  p.click("timings.compute_anew");
  EXPECT_TRUE(p.asked.compute_anew);
  p.click("timings.run.1");
  EXPECT_FALSE(p.rects.contains("timings.compute_anew"));
}

TEST(PanelsTest, AMissingSpeedHasItsReason) {
  WholeState s = loaded_state();
  EXPECT_TRUE(missing_times(s, true).empty());
  s.cgal.cold->alpha_angstrom2 = 1.4;
  ASSERT_EQ(missing_times(s, true).size(), 1u);
  EXPECT_NE(missing_times(s, true)[0].find("of alpha 0 and 1.4 Å²"), std::string::npos);
  s.cgal.cold->alpha_angstrom2 = 0;
  s.ours.cold->tetrahedra_only = true;
  EXPECT_NE(missing_times(s, true)[0].find("tetrahedra only"), std::string::npos);
  s.ours.cold->tetrahedra_only = false;
  s.cgal.cold->rebuilt = true;
  EXPECT_NE(missing_times(s, true)[0].find("No speed-up: CGAL prepared"), std::string::npos);
  s.cgal.cold->rebuilt = false;
  s.ours.cold->of_whole = s.cgal.cold->of_whole = true;
  EXPECT_NE(missing_times(s, true)[0].find("selected from the triangulation of all"),
            std::string::npos);
}

// For two balls, one run printed "slower than CGAL" and the next one "faster than CGAL".
TEST(PanelsTest, OfFewBallsNoEngineIsCalledFaster) {
  WholeState s = loaded_state();
  ASSERT_TRUE(speed_up(s, true));
  EXPECT_NEAR(*speed_up(s, true), 60.5 / 20.2, 1e-9);
  EXPECT_FALSE(speed_up(s, false)) << "there are no warm times";
  for (const std::size_t few : {0u, 2u, 99u}) {
    s.molecule.balls = few;
    EXPECT_FALSE(speed_up(s, true)) << few;
    ASSERT_EQ(missing_times(s, true).size(), 1u);
    EXPECT_NE(missing_times(s, true)[0].find("fewer than 100 balls"), std::string::npos);
  }
  s.molecule.balls = 100;
  EXPECT_TRUE(speed_up(s, true));
  EXPECT_TRUE(missing_times(s, true).empty());
}

TEST(PanelsTest, TheCaptionSaysWhyNothingIsThere) {
  WholeState s = loaded_state();
  Answer result = *s.result;
  auto balls = std::make_shared<BallSet>(*result.balls);
  balls->centres = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
  balls->radii = {1, 1, 1, 1};
  result.balls = balls;
  result.request.alpha_angstrom2 = -8;
  EXPECT_EQ(caption_text(result), "4hhb.pdb.gz   α = −8 Å²");
  result.complex.tetrahedra = {};
  EXPECT_NE(caption_text(result).find("no ball is left at this alpha"), std::string::npos);
  result.complex.vertices.simplices.resize(3);
  EXPECT_NE(caption_text(result).find("no tetrahedra at this alpha"), std::string::npos);
  auto flat = std::make_shared<BallSet>(*balls);
  for (LatticePoint& centre : flat->centres) centre.z = 0;
  result.balls = flat;
  EXPECT_NE(caption_text(result).find("balls in a plane"), std::string::npos);
  auto line = std::make_shared<BallSet>(*flat);
  for (LatticePoint& centre : line->centres) centre.y = 2 * centre.x;
  result.balls = line;
  EXPECT_NE(caption_text(result).find("balls on a line"), std::string::npos);
  result.balls = balls;
  result.complex.vertices = {};
  result.complex.tetrahedra_only = true;  // then vertices are not counted
  EXPECT_NE(caption_text(result).find("no tetrahedra at this alpha"), std::string::npos);
}

TEST(PanelsTest, AChoiceOfTimesStaysAlsoWhenThereAreNone) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();  // cold only
  p.frame(2);
  const auto shows_cold = [&p] {
    return testing::memory_of<TimingsState>(p.panels, "timings").cold;
  };
  p.click("timings.run.1");
  EXPECT_FALSE(shows_cold());
  EXPECT_TRUE(p.rects.contains("timings.missing"));
  p.click("timings.run.0");
  EXPECT_TRUE(shows_cold());
  EXPECT_FALSE(p.rects.contains("timings.missing"));
}

TEST(PanelsTest, SavingSaysWhatItReplacesAndWhichFolderIsMissing) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.dialogs.show_save = true;
  const auto folder = std::filesystem::temp_directory_path();
  p.state.dialogs.save_path = (folder / "alphascope no such picture.png").string();
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("save.replaces"));
  EXPECT_FALSE(p.rects.contains("save.no_folder"));
  const float bottom = p.rects["save.ok"].y1;
  p.state.dialogs.save_path = (folder / "alphascope no such folder" / "x.png").string();
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("save.no_folder"));
  EXPECT_FLOAT_EQ(p.rects["save.ok"].y1, bottom) << "nothing jumps while one types";
  p.state.dialogs.save_path = std::string(ALPHASCOPE_SOURCE_DIR) + "/README.md";
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("save.replaces")) << "it will be README.md.png";
  p.state.dialogs.save_path = std::string(ALPHASCOPE_SOURCE_DIR) + "/docs/images/cavity.png";
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("save.replaces"));
  p.state.dialogs.save_path = (folder / "figure 1").string();
  p.frame(2);
  p.click("save.ok");
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->path, folder / "figure 1.png");
}

TEST(PanelsTest, SavingOffersALegendWhereThereIsOne) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  const auto saved_with = [&](std::initializer_list<const char*> clicks) {
    p.state.dialogs.show_save = true;
    p.frame(3);
    for (const char* name : clicks) p.click(name);
    p.click("save.ok");
    return p.asked.screenshot->options;
  };
  p.click("view");
  EXPECT_TRUE(saved_with({"save.legend"}).legend) << "without one there is nothing to switch off";
  EXPECT_FALSE(saved_with({}).scale_bar);
  EXPECT_TRUE(saved_with({"save.scale_bar"}).scale_bar);
  p.state.viewport.legends = {ColourLegend{"alpha value (Å²)", {{{}, 0}, {{}, 1}}}};
  EXPECT_FALSE(saved_with({"save.legend"}).legend);
  EXPECT_TRUE(saved_with({"save.legend"}).legend) << "the choice was kept";
}

TEST(PanelsTest, SectionsOutOfSightAreOneClickAway) {
  Panels tall({1920, 1800, 1});
  tall.state = loaded_state();
  tall.frame(3);
  EXPECT_TRUE(tall.rects["engine"].visible);
  EXPECT_FALSE(tall.rects.contains("sections.engine")) << "all is in sight";
}

TEST(PanelsTest, SectionsOutOfSightOpenAtTheTop) {
  Panels p({1100, 500, 1});
  p.state = loaded_state();
  for (int i = 0; i < 12; ++i) p.state.molecule.summary += "\nanother line";
  p.frame(3);
  for (const char* name : {"engine", "display", "molecule"}) {
    const std::string button = std::string("sections.") + name;
    ASSERT_TRUE(p.rects.contains(button)) << name;
    EXPECT_FALSE(p.rects[name].visible) << name;
    p.click(button);
    p.frame(2);
    EXPECT_TRUE(p.rects[name].visible) << name;
    EXPECT_GE(p.rects[name].y0, p.rects[button].y1) << name;
  }
  EXPECT_LT(p.rects["molecule"].y0, p.rects["sections.molecule"].y1 + 30);
  p.click("molecule", 0.05f);  // folded
  ASSERT_FALSE(p.rects.contains("molecule.open"));
  p.click("sections.molecule");
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("molecule.open"));
}

TEST(PanelsTest, NamesOfPagesFitNarrowWindows) {
  for (const float width : {700.0f, 960.0f, 1100.0f, 1280.0f}) {
    Panels p({width, 700, 1});
    p.state = loaded_state();
    p.frame(3);
    for (const PanelSpec& page : panels()) {
      if (page.place != PanelPlace::bottom) continue;
      const WidgetRect name = p.rects["bottom." + std::string(page.id)];
      EXPECT_TRUE(name.visible) << page.id;
      EXPECT_LE(name.x1, width) << page.id << " at " << width;
      if (width >= 900) {
        EXPECT_EQ(name.y0, p.rects["bottom.timings"].y0) << page.id << ": one line";
      }
    }
  }
}

class PanelsAtEverySize : public ::testing::TestWithParam<Size> {};

TEST_P(PanelsAtEverySize, NothingLeavesTheWindow) {
  const Size size = GetParam();
  Panels p(size);
  p.state = loaded_state();
  p.state.molecule.summary += std::string(300, 'x');  // one word that cannot be wrapped
  p.frame(3);
  const float width = size.width * size.scale, height = size.height * size.scale;
  for (const char* name :
       {"molecule.open", "molecule.sample", "alpha.slider", "alpha.preset.10", "alpha.water",
        "timings.badge", "timings.waterfall", "status.hash", "status.memory", "view"}) {
    ASSERT_TRUE(p.rects.contains(name)) << name;
    const WidgetRect r = p.rects[name];
    EXPECT_GE(r.x0, 0) << name;
    EXPECT_LE(r.x1, width + 0.5f) << name;
    EXPECT_LE(r.y1, height + 0.5f) << name;
    EXPECT_GT(r.x1, r.x0) << name;
  }
  EXPECT_LE(p.rects["alpha.preset.10"].x1, p.rects["view"].x0);
  EXPECT_LE(p.rects["status.hash"].x1, p.rects["status.memory"].x0);
  EXPECT_GT(p.state.viewport.height, 100);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PanelsAtEverySize,
                         ::testing::Values(Size{1100, 700, 1}, Size{1280, 800, 1},
                                           Size{1920, 1080, 1}, Size{1280, 800, 2}));

// Texts that depend on a choice have room reserved. So nothing below them moves when they change.
TEST(PanelsStay, WhereTheyAreWhateverIsSaid) {
  Panels p({1280, 1400, 1});
  p.state = loaded_state();
  p.frame(3);
  const auto places = [&p] {
    std::vector<float> y;
    for (const char* name : {"molecule.polymers", "alpha", "alpha.slider", "display", "engine"}) {
      EXPECT_TRUE(p.rects.contains(name)) << name;
      y.push_back(p.rects[name].y0);
    }
    return y;
  };
  const std::vector<float> usual = places();
  const std::vector<std::pair<const char*, std::function<void(ViewState&)>>> changes{
      {"dropped",
       [](auto& s) {
         s.molecule.dropped = {{"221 waters", "HOH 221"}};
       }},
      {"no notes", [](auto& s) { s.molecule.notes.clear(); }},
      {"guessed", [](auto& s) { s.molecule.radius_rows.resize(1); }},
      {"summary", [](auto& s) { s.molecule.summary = "used 4,558 of 4,558 atoms"; }},
      {"error", [](auto& s) { s.expression_error.emplace(8, "this ) has no opening ("); }},
      {"typed", [](auto& s) { s.expression.typed = "chain A"; }},
      {"no balls", [](auto& s) { s.settings.display.balls = false; }},
      {"no tetrahedra", [](auto& s) { s.settings.display.tetrahedra = false; }},
      {"edges", [](auto& s) { s.settings.display.edges = true; }},
      {"tetrahedra only", [](auto& s) {
         Answer result = *s.result;
         s.settings.display.edges = result.complex.tetrahedra_only = true;
         s.result = std::make_shared<Answer>(result);
       }}};
  for (const auto& [name, change] : changes) {
    const WholeState before = p.state;
    change(p.state);
    p.frame(2);
    EXPECT_EQ(places(), usual) << name;
    p.state = before;
    p.frame(2);
  }
}

}  // namespace
}  // namespace alphascope
