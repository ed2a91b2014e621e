// SPDX-License-Identifier: GPL-3.0-or-later
// Tests dialogs above one another, and where errors are shown.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <string_view>

#include "core/document/settings/request.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/error_kind.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;

class DialogsTest : public ::testing::Test {
 protected:
  DialogsTest() {
    p.state = loaded_state();
    p.frame(2);
  }
  // Expects these widgets in every frame. Dialogs must not replace one another from frame to frame.
  void expect_steady(std::initializer_list<const char*> widgets) {
    for (int i = 0; i < 6; ++i) {
      p.frame();
      for (const char* name : widgets) EXPECT_TRUE(p.rects.contains(name)) << name;
    }
  }
  Panels p{{1280, 800, 1}};
};

TEST_F(DialogsTest, TheCheatSheetOpensAboveTheBenchmarkPage) {
  p.state.dialogs.show_benchmark = true;
  p.frame(3);
  p.tap(key::kF1);
  p.frame(3);
  expect_steady({"benchmark.run", "cheat_sheet.close"});
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(p.state.dialogs.show_cheat_sheet);
  EXPECT_TRUE(p.state.dialogs.show_benchmark) << "Escape is for the dialog on top";
  p.tap(key::kF1);
  p.frame(3);
  p.click("cheat_sheet.close");
  p.click("benchmark.close");
  EXPECT_FALSE(p.state.dialogs.show_benchmark);
  p.click("alpha.preset.3");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3)
      << "the mouse is the window's again";
}

TEST_F(DialogsTest, AnErrorOpensAboveTheFileBrowserWhichStays) {
  p.state.browser.show = true;
  p.state.browser.folder = "/";
  p.frame(3);
  p.state.browser.typed = "/tmp/what I typed";
  p.state.show_error("The file cannot be opened", "x.pdb, line 3: no number.", ErrorKind::input);
  p.frame(3);
  expect_steady({"browser.cancel", "error.ok"});
  p.click("error.ok");
  p.frame(2);
  EXPECT_TRUE(p.state.error.empty());
  EXPECT_EQ(p.state.browser.typed, "/tmp/what I typed");
  p.click("browser.cancel");
  EXPECT_FALSE(p.state.browser.show);
  p.click("alpha.preset.3");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3);
}

TEST_F(DialogsTest, EveryErrorIsToldOneAfterTheOther) {
  const auto kind_of = [](std::string_view text) {
    return text == "second" ? ErrorKind::output : ErrorKind::input;
  };
  for (const char* text : {"first", "second", "second", "third"})
    p.state.show_error("title", text, kind_of(text));
  for (const char* text : {"first", "second", "third"}) {
    p.frame(3);
    EXPECT_EQ(p.state.error, text);
    EXPECT_EQ(p.state.error_kind, kind_of(text));
    p.click("error.ok");
  }
  p.frame(3);
  EXPECT_TRUE(p.state.error.empty());
  EXPECT_FALSE(p.rects.contains("error.ok"));
}

TEST_F(DialogsTest, AKeyThatClosesADialogLeavesTheMouseToTheWindow) {
  p.tap(key::kF1);
  p.frame(3);
  p.tap(key::kF1);
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("cheat_sheet.close"));
  p.click("alpha.preset.3");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3);
}

TEST_F(DialogsTest, CancelIsAtTheLeftOfWhatIsDone) {
  p.state.molecule.assemblies = {{"1", "", 60, 1000000, 1}};
  const auto at_left = [&](const char* cancel, const char* confirm) {
    p.frame(4);
    const WidgetRect c = p.rects.at(cancel), ok = p.rects.at(confirm);
    EXPECT_LT(c.x1, ok.x0) << cancel;
    EXPECT_FLOAT_EQ(c.y0, ok.y0) << cancel;
  };
  p.state.dialogs.show_save = true;
  at_left("save.cancel", "save.ok");
  p.state.browser.show = true;
  at_left("browser.cancel", "browser.open");
  p.state.dialogs.confirm_assembly = "1";
  at_left("assembly.cancel", "assembly.expand");
  p.state.dialogs.show_benchmark = true;
  at_left("benchmark.cancel", "benchmark.run");
}

// The smallest window is as kLeastWidth and kLeastHeight of ui/window/glfw_host.cpp say.
TEST(Dialogs, HaveTheirButtonsInTheSmallestWindow) {
  const auto expect_inside = [](const char* prefix, std::initializer_list<const char*> buttons,
                                const std::function<void(ViewState&)>& open) {
    for (const float scale : {1.0f, 2.0f}) {
      Panels p{{900, 600, scale}};
      p.state = loaded_state();
      p.state.molecule.assemblies = {{"1", "", 60, 1000000, 1}};
      open(p.state);
      p.frame(6);
      for (const char* name : buttons) {
        ASSERT_TRUE(p.rects.contains(name)) << name;
        const WidgetRect& r = p.rects.at(name);
        EXPECT_TRUE(r.visible && r.y0 >= 0 && r.y1 <= 600 * scale) << name << " at " << r.y1;
      }
      for (const auto& [name, r] : p.rects) {
        if (!name.starts_with(prefix)) continue;
        EXPECT_TRUE(r.x0 >= 0 && r.x1 <= 900 * scale) << name << " ends at " << r.x1;
      }
    }
  };
  expect_inside("benchmark.", {"benchmark.cancel", "benchmark.run", "benchmark.close"},
                [](ViewState& s) { s.dialogs.show_benchmark = true; });
  expect_inside("browser.", {"browser.cancel", "browser.open"},
                [](ViewState& s) { s.browser.show = true; });
  expect_inside("save.", {"save.cancel", "save.ok"},
                [](ViewState& s) { s.dialogs.show_save = true; });
  expect_inside("record.", {"record.cancel", "record.ok"},
                [](ViewState& s) { s.record.show = true; });
  expect_inside("export.", {"export.cancel", "export.ok"},
                [](ViewState& s) { s.dialogs.show_export = true; });
  expect_inside("save_session.", {"save_session.cancel", "save_session.ok"},
                [](ViewState& s) { s.dialogs.show_save_session = true; });
  expect_inside("assembly.", {"assembly.cancel", "assembly.expand"},
                [](ViewState& s) { s.dialogs.confirm_assembly = "1"; });
  expect_inside("cheat_sheet.", {"cheat_sheet.close"},
                [](ViewState& s) { s.dialogs.show_cheat_sheet = true; });
  expect_inside("about.", {"about.close"}, [](ViewState& s) { s.dialogs.show_about = true; });
  expect_inside("error.", {"error.copy", "error.ok"}, [](ViewState& s) {
    for (int line = 0; line < 60; ++line) s.error += "Line of a long message.\n";
  });
}

TEST_F(DialogsTest, APictureIsSavedOnlyWhereThereIsAFolder) {
  p.state.dialogs.show_save = true;
  p.state.dialogs.save_path = "/no/such/folder/picture.png";
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("save.no_folder"));
  p.click("save.ok");
  EXPECT_FALSE(p.asked.screenshot);
  EXPECT_TRUE(p.state.dialogs.show_save);
  p.state.dialogs.save_path = "/tmp/picture.png";
  p.frame(3);
  p.click("save.ok");
  EXPECT_FALSE(p.state.dialogs.show_save);
}

TEST_F(DialogsTest, APlaceWithoutANameIsNoFile) {
  p.state.dialogs.show_save = true;
  p.frame(3);
  const std::string folder = std::filesystem::temp_directory_path().string();
  for (const std::string& typed : {std::string(), std::string("  "), folder, folder + "/"}) {
    p.state.dialogs.save_path = typed;
    p.frame(3);
    EXPECT_TRUE(p.rects.contains("save.no_name")) << typed;
    p.click("save.ok");
    EXPECT_FALSE(p.asked.screenshot) << typed;
  }
}

TEST(TypedPaths, AreWholeWhateverIsTyped) {
  const char* const before = std::getenv("HOME");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("HOME", "/home/ada", 1);
  EXPECT_EQ(typed_path("~/a.png"), "/home/ada/a.png");
  EXPECT_EQ(typed_path(" ~ "), "/home/ada");
  EXPECT_EQ(typed_path("~ada/a.png", "/b"), "/b/~ada/a.png") << "of other users nothing is known";
  EXPECT_EQ(typed_path("../a.png", "/b/c"), "/b/a.png");
  EXPECT_EQ(typed_path("a.png"), std::filesystem::current_path() / "a.png");
  EXPECT_EQ(typed_path("/x//y/./a.png "), "/x/y/a.png");
  EXPECT_EQ(typed_path(" "), "");
  EXPECT_EQ(path_to_save("~/a", ".png"), "/home/ada/a.png");
  EXPECT_EQ(path_to_save("/tmp", ".png"), "/tmp") << "a folder gets no ending";
  EXPECT_EQ(path_to_save("/tmp/", ".png"), "/tmp/");
  EXPECT_EQ(path_to_save("", ".png"), "");
  ::setenv("HOME", kept.c_str(), 1);
}

TEST_F(DialogsTest, WhatCannotBeWrittenIsSaidBeforeItIsTried) {
  p.state.dialogs.show_export = true;
  p.state.dialogs.export_path = "/tmp/alphascope no such file.stl";
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("export.unwritable"));
  // A folder with the file's name stops the export. An unwritable path would not, if the user who
  // runs the tests may write everywhere.
  const std::string folder = std::filesystem::temp_directory_path() / "alphascope_folder.stl";
  std::filesystem::create_directory(folder);
  p.state.dialogs.export_path = folder;
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("export.no_name"));
  p.click("export.ok");
  EXPECT_TRUE(p.state.dialogs.show_export);
  std::filesystem::remove(folder);
}

// Without a computed result there are no numbers.
TEST_F(DialogsTest, NumbersAreCompleteOnlyWhereTheyWereComputed) {
  p.state.viewport.not_drawn = "Not drawn for lack of memory: edges.";
  p.state.result = loaded_state().result;
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("view.numbers_complete"));
  p.state.compute_error = "There is not enough memory for this alpha.";
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("view.not_drawn"));
  EXPECT_FALSE(p.rects.contains("view.numbers_complete"));
}

// --- the program behind the dialogs

class ErrorsTest : public testing::ViewerTest {
 protected:
  ErrorsTest() {
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    Session::Services services = Session::program_services();
    services.make_engine = [this, make = services.make_engine](auto&&... arguments) {
      if (no_memory_) throw std::bad_alloc();
      return make(arguments...);
    };
    services.is_memory_unused = [this] {  // asked at each step
      if (!fault_.empty()) throw std::runtime_error(std::exchange(fault_, {}));
      return false;
    };
    viewer_.reset();  // the fixture's; there is one ImGui
    viewer_ = std::make_unique<Viewer>(*host_, options, services);
    open_crambin();
  }
  ~ErrorsTest() override { viewer_.reset(); }  // before what its services use
  bool no_memory_ = false;
  std::string fault_;
};

TEST_F(ErrorsTest, AStepThatFailsIsALineAndNotADialog) {
  no_memory_ = true;
  run("click alpha.water\nwait-idle\nframes 3\n");
  const ViewState& s = viewer_->state();
  EXPECT_TRUE(s.error.empty()) << s.error;
  EXPECT_NE(s.compute_error.find("etrahedra only"), std::string::npos) << s.compute_error;
  EXPECT_TRUE(viewer_->widgets().contains("view.compute_error"));
  no_memory_ = false;
  const std::string first = s.compute_error;
  run("click alpha.water\nwait-idle\nframes 3\n");
  EXPECT_TRUE(s.compute_error.empty());
  EXPECT_EQ(s.first_compute_error, first) << "a script ends with it";
  EXPECT_TRUE(s.result);
}

// The message about one alpha must disappear when alpha changes, even if the next answer takes long
// or is cancelled.
TEST_F(ErrorsTest, TheErrorGoesWithItsAlpha) {
  no_memory_ = true;
  run("click alpha.water\nwait-idle\nframes 3\n");  // other balls need another engine
  ASSERT_FALSE(viewer_->state().compute_error.empty());
  set_alpha(viewer_->state().settings.request, 10);
  ScriptedInput no_input;
  viewer_->step(&no_input);  // too short for the next answer or error
  EXPECT_TRUE(viewer_->state().compute_error.empty()) << viewer_->state().compute_error;
}

TEST_F(ErrorsTest, OnlyAFailedOpeningSpeaksOfThePreviousMolecule) {
  const ViewState& s = viewer_->state();
  run("open /no/such/file.pdb\nwait-idle\n");
  EXPECT_NE(s.error.find("The previous molecule is still open."), std::string::npos) << s.error;
  run("click error.ok\nframes 2\n");
  EXPECT_EQ(s.withdrawn_error, "") << "it was dismissed";
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{"/no/such/folder/p.png", {.width = 64, .height = 64}});
  run("wait-idle\n");
  EXPECT_NE(s.error.find("/no/such/folder"), std::string::npos) << s.error;
  EXPECT_EQ(s.error.find("still open"), std::string::npos) << s.error;
}

TEST_F(ErrorsTest, AFailedOpeningIsToldNoMoreWhenAnotherFileIsOpen) {
  ViewState& s = viewer_->state();
  run("open /no/such/file.pdb\nwait-idle\nframes 3\n");
  EXPECT_EQ(s.error_title, "The file cannot be opened");
  EXPECT_TRUE(viewer_->widgets().contains("error.ok"));
  s.show_error("The picture cannot be saved", "The disk is full.", ErrorKind::output);
  const auto another = testing::fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz";
  run("open " + another.string() + "\nwait-idle\nframes 3\n");
  EXPECT_EQ(s.molecule.name, "4hhb.pdb.gz");
  EXPECT_EQ(s.error_title, "The picture cannot be saved") << "this is still true";
  EXPECT_NE(s.withdrawn_error.find("/no/such/file.pdb"), std::string::npos) << "a script ends so";
  EXPECT_TRUE(s.more_errors.empty());
  run("click error.ok\nframes 3\n");
  EXPECT_EQ(s.error, "");
  EXPECT_TRUE(s.dialogs.open.empty());
}

TEST_F(ErrorsTest, OnlyAFolderInWhichAFileWasWrittenIsOfferedAgain) {
  const std::filesystem::path& folder = viewer_->state().saving.folder;
  const auto save = [&](const std::filesystem::path& path) {
    viewer_->calls().jobs.save_picture(ScreenshotRequest{path, {.width = 64, .height = 64}});
    run("wait-idle\nframes 3\n");
  };
  save("/proc/x.png");
  EXPECT_NE(viewer_->state().error, "");
  EXPECT_EQ(folder, "");
  run("click error.ok\nframes 2\n");
  save(folder_ / "x.png");
  EXPECT_EQ(folder, folder_);
  save("/proc/x.png");
  EXPECT_NE(viewer_->state().error, "");
  EXPECT_EQ(folder, folder_);
}

TEST_F(ErrorsTest, AFailedComparisonIsToldByTheBadge) {
  no_memory_ = true;
  run("click bottom.timings\nclick timings.compare\nwait-idle\nframes 3\n");
  const ViewState& s = viewer_->state();
  EXPECT_TRUE(s.error.empty()) << s.error;
  EXPECT_EQ(s.badge.state, BadgeInfo::State::failed);
  EXPECT_NE(s.badge.text.find("not enough memory"), std::string::npos) << s.badge.text;
  no_memory_ = false;
  run("click timings.compare\nwait-idle\nframes 3\n");
  EXPECT_EQ(s.badge.state, BadgeInfo::State::identical);
}

TEST_F(ErrorsTest, AnExceptionOnTheMainThreadIsShownAndTheProgramGoesOn) {
  fault_ = "a fault in a step of the main thread";
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().error, "a fault in a step of the main thread");
  run("click error.ok\nclick alpha.preset.3\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().result->request.alpha_angstrom2, 3);
}

TEST_F(ErrorsTest, NothingIsOpenedWhileABenchmarkRuns) {
  ViewState& s = viewer_->state();
  run("click menu.Tools\nclick menu.benchmark.open\nclick benchmark.run\n");
  run("open " +
      (testing::fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz").string() +
      "\nframes 2\n");
  EXPECT_NE(s.error.find("4hhb.pdb.gz was not opened"), std::string::npos) << s.error;
  run("click error.ok\nclick benchmark.cancel\nwait-idle\n");
  EXPECT_EQ(s.molecule.name, "1crn.pdb");
}

}  // namespace
}  // namespace alphascope
