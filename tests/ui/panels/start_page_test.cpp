// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the start page, the page that is first below the view, and the section that does not
// scroll.
#include <set>

#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

// A window without a molecule.
class StartPage : public ::testing::Test {
 protected:
  StartPage() {
    p.state.samples = {{"crambin", "1CRN", "1crn.pdb"}, {"haemoglobin", "4HHB", "4hhb.pdb.gz"}};
    p.frame(3);
  }
  Panels p{{1280, 800, 1}};
};

TEST_F(StartPage, ADoorOpensTheSampleAndThePage) {
  p.click("start.cavities");
  EXPECT_EQ(p.asked.open, "4hhb.pdb.gz");
  EXPECT_EQ(p.state.page(), "cavities");
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.4);
  EXPECT_FALSE(p.state.start.picture_of);
  p.click("start.picture");
  EXPECT_EQ(p.state.start.picture_of, "4hhb.pdb.gz");
  p.click("start.learn");
  EXPECT_TRUE(p.state.lessons.shown && p.state.lessons.list);
}

TEST_F(StartPage, WithoutSamplesADoorAsksForAFile) {
  p.state.samples.clear();
  p.frame(2);
  p.click("start.picture");
  EXPECT_TRUE(p.state.browser.show);
  EXPECT_FALSE(p.asked.open);
  EXPECT_EQ(p.state.start.picture_of, "") << "of any file";
}

TEST_F(StartPage, RecentFilesAreOpenedAndFetchedOnesHaveTheirId) {
  p.state.recent = {crambin(),
                    "/home/a/.cache/alphascope/https/files.rcsb.org/download/1CRN.cif.gz",
                    "/nonexistent/a.pdb"};
  p.frame(3);
  p.click("start.recent.0");
  EXPECT_EQ(p.asked.open, crambin());
  p.asked.open.reset();
  p.click("start.recent.1");
  ASSERT_TRUE(p.asked.fetch);
  EXPECT_EQ(p.asked.fetch->text(), "pdb:1CRN");
  EXPECT_FALSE(p.asked.open);
  p.click("start.recent.2");
  EXPECT_NE(p.state.error.find("There is no file /nonexistent/a.pdb"), std::string::npos);
}

TEST_F(StartPage, TheFieldFetches) {
  p.type("start.id", "pdb:../x");
  EXPECT_FALSE(p.asked.fetch);
  p.click("start.fetch");
  EXPECT_FALSE(p.asked.fetch) << "the button is off";
  p.type("start.id", "af:p69905");
  ASSERT_TRUE(p.asked.fetch);
  EXPECT_EQ(p.asked.fetch->text(), "af:P69905");
  p.asked.fetch.reset();
  p.state.fetch.options.offline = true;
  p.click("start.fetch");
  EXPECT_FALSE(p.asked.fetch);
}

TEST_F(StartPage, TabWalksThroughIt) {
  p.state.recent = {crambin()};
  p.frame(2);
  std::set<std::string> seen;
  for (int n = 0; n < 300; ++n) {
    p.tap(key::kTab);
    if (!seen.insert(p.state.keys.at.back().name).second) break;
  }
  for (const char* name : {"start.cavities", "start.picture", "start.learn", "start.open",
                           "start.sample.1", "start.id", "start.recent.0"}) {
    EXPECT_TRUE(seen.contains(name)) << name;
  }
}

class StartPageAtEverySize : public ::testing::TestWithParam<Size> {};

TEST_P(StartPageAtEverySize, AllOfItIsInTheView) {
  Panels p(GetParam());
  p.state.samples = {{"crambin", "1CRN", "1crn.pdb"}, {"haemoglobin", "4HHB", "4hhb.pdb.gz"}};
  p.state.recent = {"/data/" + std::string(80, 'x') + ".pdb", "/data/b.pdb"};
  for (int n = 0; n < 10; ++n) p.state.recent.push_back("/data/" + std::to_string(n) + ".pdb");
  p.frame(4);
  const WidgetRect view = p.rects["view"];
  std::vector<WidgetRect> seen;
  for (const auto& [name, r] : p.rects) {
    if (!name.starts_with("start.")) continue;
    EXPECT_TRUE(r.visible) << name;
    EXPECT_GE(r.x0, view.x0) << name;
    EXPECT_LE(r.x1, view.x1) << name;
    EXPECT_GE(r.y0, view.y0) << name;
    EXPECT_LE(r.y1, view.y1) << name;
    for (const WidgetRect& other : seen) {
      const bool apart = r.x1 <= other.x0 + 1 || other.x1 <= r.x0 + 1 || r.y1 <= other.y0 + 1 ||
                         other.y1 <= r.y0 + 1;
      EXPECT_TRUE(apart) << name << " lies over another";
    }
    seen.push_back(r);
  }
  EXPECT_GE(seen.size(), 9u + 4) << "at least four recent files";
  EXPECT_LE(seen.size(), 9u + 8);
}

INSTANTIATE_TEST_SUITE_P(Sizes, StartPageAtEverySize,
                         ::testing::Values(Size{900, 600, 1}, Size{900, 600, 2}, Size{1280, 800, 1},
                                           Size{1280, 800, 2}, Size{1920, 1080, 1}));

class AlphaSection : public ::testing::TestWithParam<Size> {};

TEST_P(AlphaSection, IsNeverOutOfSight) {
  Panels p(GetParam());
  p.state = loaded_state();
  p.frame(4);
  for (const char* section : {"", "engine", "clip", "molecule"}) {
    p.state.scroll.section = section;
    p.frame(4);
    for (const char* name : {"alpha.slider", "alpha.typed", "alpha.preset.10", "alpha.solvent"}) {
      ASSERT_TRUE(p.rects.contains(name)) << name;
      EXPECT_TRUE(p.rects[name].visible) << name << " with " << section;
    }
    if (*section != 0) {
      EXPECT_TRUE(p.rects[section].visible) << section;
      EXPECT_GE(p.rects[section].y0, p.rects["alpha.solvent"].y1) << "the others scroll below it";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, AlphaSection,
                         ::testing::Values(Size{900, 600, 1}, Size{900, 600, 2}, Size{1280, 800, 1},
                                           Size{1920, 1080, 1}));

TEST(FirstPage, IsCavitiesForAPolymerUnlessAnotherWasChosen) {
  Panels p({1280, 800, 1});
  const auto shown = [&p] {
    p.frame(3);
    return p.rects.contains("timings.badge") ? "timings" : p.state.page();
  };
  p.state = loaded_state();
  EXPECT_EQ(shown(), "timings") << "no polymer";
  p.state.molecule.contents.kinds[static_cast<std::size_t>(ResidueKind::polymer)] = 4000;
  EXPECT_EQ(shown(), "cavities");
  p.click("bottom.timings");
  EXPECT_EQ(shown(), "timings");
  EXPECT_EQ(p.state.window.chosen_page, "timings");
}

class StartOfTheProgram : public ViewerTest {
 protected:
  void restart() {
    viewer_.reset();
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    options.preferences = folder_ / "config";
    viewer_ = std::make_unique<Viewer>(*host_, options);
    run("wait-idle\n");
  }
};

TEST_F(StartOfTheProgram, RemembersTheChosenPageOnly) {
  restart();
  open_crambin();
  EXPECT_EQ(viewer_->state().page(), "cavities");
  run("select.atoms A:15\nwhy.show\n");
  EXPECT_EQ(viewer_->state().page(), "why");
  restart();
  open_crambin();
  EXPECT_EQ(viewer_->state().page(), "cavities") << "nobody chose the page Why?";
  run("view.page timings\n");
  restart();
  open_crambin();
  EXPECT_EQ(viewer_->state().page(), "timings");
}

TEST_F(StartOfTheProgram, TheDoorsLeadToTheDialogAndThePage) {
  run("wait-idle\nframes 3\nclick start.picture\nwait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().molecule.name, "4hhb.pdb.gz");
  EXPECT_TRUE(viewer_->widgets().contains("save.path"));
  run("key esc\nframes 2\nkey esc\nframes 2\nopen " + crambin().string() +
      "\nwait-idle\nframes 2\n");
  EXPECT_FALSE(viewer_->state().dialogs.show_save) << "once";
}

}  // namespace
}  // namespace alphascope::testing
