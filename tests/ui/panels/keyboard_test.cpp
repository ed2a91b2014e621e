// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the window without a mouse. Tab leads to fields and buttons, Enter and Space press them,
// dialogs take the keyboard, Alt and F10 open the menus.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "core/document/settings/paint.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/panel.hpp"
#include "ui/window/input_queue.hpp"

namespace alphascope::testing {
namespace {

namespace fs = std::filesystem;

class Keyboard : public ::testing::Test {
 protected:
  Keyboard() {
    p.state = loaded_state();
    p.frame(3);
  }
  ViewState& state() { return p.state; }
  std::string at() { return state().keys.at.back().name; }
  bool marked() { return state().keys.at.back().shown; }
  void tab(int count = 1) {
    for (int i = 0; i < count; ++i) p.tap(key::kTab);
  }
  void back() {
    ImGui::GetIO().KeyShift = true;
    p.tap(key::kTab);
    ImGui::GetIO().KeyShift = false;
  }
  // Presses Tab until the keyboard is at this widget, or has been everywhere.
  bool tab_to(const std::string& name) {
    for (int i = 0; i < 300 && at() != name; ++i) tab();
    return at() == name;
  }
  void letters(const std::string& text) {
    for (const char c : text) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
      p.frame();
    }
  }
  static bool typing() { return ImGui::GetIO().WantTextInput; }

  Panels p{{1280, 800, 1}};
};

TEST_F(Keyboard, TabGoesToEveryFieldAndButtonOnceAndBack) {
  tab();
  const std::string first = at();
  EXPECT_FALSE(first.empty());
  EXPECT_TRUE(marked());
  std::set<std::string> seen;
  std::vector<std::string> order;
  do {
    EXPECT_TRUE(seen.insert(at()).second) << at();
    order.push_back(at());
    tab();
  } while (at() != first && order.size() < 300);
  EXPECT_EQ(at(), first) << "after the last comes the first";
  for (const char* name : {"alpha.slider", "alpha.typed", "alpha.preset.3", "alpha.water",
                           "engine.choice", "display", "bottom.cavities"}) {
    EXPECT_TRUE(seen.contains(name)) << name;
  }
  back();
  EXPECT_EQ(at(), order.back());
}

TEST_F(Keyboard, WhatTabComesToIsInSight) {
  tab_to("engine.choice");
  p.frame(3);
  EXPECT_TRUE(p.rects["engine.choice"].visible);
}

TEST_F(Keyboard, SpaceAndEnterPress) {
  ASSERT_TRUE(tab_to("alpha.preset.3"));
  p.tap(key::kSpace);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3);
  ASSERT_TRUE(tab_to("alpha.preset.10"));
  p.tap(key::kEnter);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 10);
}

TEST_F(Keyboard, WhatIsTypedGoesIntoTheFieldThatTabComesTo) {
  ASSERT_TRUE(tab_to("alpha.typed"));
  p.frame();
  EXPECT_TRUE(typing());
  letters("1.5");
  tab();
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.5) << "Tab takes what was typed";
  EXPECT_FALSE(typing());
}

// ImGui drops the characters of the frame in which a field begins.
TEST_F(Keyboard, NothingThatIsTypedAtOnceIsLost) {
  ASSERT_TRUE(tab_to("alpha.typed"));
  back();
  ImGui::GetIO().AddInputCharacter('7');
  tab();
  letters("5");
  p.tap(key::kEnter);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 75);
}

TEST_F(Keyboard, ASliderIsMovedByArrowsAndTypedAfterEnter) {
  ASSERT_TRUE(tab_to("display.ball_scale"));
  const float before = p.state.settings.display.ball_scale;
  p.tap(key::kRight);
  EXPECT_GT(p.state.settings.display.ball_scale, before);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0)
      << "not alpha's while a slider has it";
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(typing());
  letters("50");
  p.tap(key::kEnter);
  EXPECT_FLOAT_EQ(p.state.settings.display.ball_scale, 0.5f);
}

TEST_F(Keyboard, ArrowsAreAlphasAndLettersAreCommandsBesideFields) {
  ASSERT_TRUE(tab_to("alpha.preset.3"));
  p.tap(key::kRight);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0.1);
  p.tap(key::kB);
  EXPECT_FALSE(p.state.settings.display.balls);
}

TEST_F(Keyboard, AClickGoesOnFromThere) {
  p.click("alpha.preset.3");
  EXPECT_EQ(at(), "alpha.preset.3");
  EXPECT_FALSE(marked());
  tab();
  EXPECT_EQ(at(), "alpha.preset.10");
  EXPECT_TRUE(marked());
}

TEST_F(Keyboard, GreyButtonsAreLeftOut) {
  tab();
  const std::string first = at();
  do {
    EXPECT_NE(at(), "badge.cancel");
    tab();
  } while (at() != first);
  state().dialogs.show_save = true;
  state().dialogs.save_path = "/no/such/folder/a.png";
  p.frame(4);
  for (int i = 0; i < 40; ++i) {
    tab();
    EXPECT_NE(at(), "save.ok");
  }
}

// --- lists and menus

TEST_F(Keyboard, AListIsOpenedChosenFromAndClosed) {
  std::set<EngineChoice> chosen;
  for (int down = 1; down < 8; ++down) {
    ASSERT_TRUE(tab_to("engine.choice"));
    p.tap(key::kEnter);
    p.frame(3);
    EXPECT_TRUE(state().keys.list_open);
    for (int i = 0; i < down; ++i) p.tap(key::kDown);
    p.tap(key::kEnter);
    p.frame(3);
    EXPECT_FALSE(state().keys.list_open);
    chosen.insert(p.state.settings.request.engine);
  }
  EXPECT_GT(chosen.size(), 2u);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0);
}

TEST_F(Keyboard, EscapeClosesTheListAndNotItsDialog) {
  state().dialogs.show_export = true;
  p.frame(4);
  ASSERT_TRUE(tab_to("export.format"));
  p.tap(key::kSpace);
  p.frame(2);
  ASSERT_TRUE(state().keys.list_open);
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(state().keys.list_open);
  EXPECT_TRUE(state().dialogs.show_export);
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(state().dialogs.show_export);
}

TEST_F(Keyboard, F10AndAltOpenTheMenus) {
  for (const int code : {key::kF1 + 9, key::kLeftAlt, key::kRightAlt}) {
    p.tap(code);
    p.frame(3);
    EXPECT_TRUE(p.rects.contains("menu.file.open")) << code;
    p.tap(key::kEscape);
    p.frame(2);
    EXPECT_FALSE(p.rects.contains("menu.file.open")) << code;
    p.tap(code);
    p.frame(3);
    EXPECT_TRUE(p.rects.contains("menu.file.open")) << code;
    p.tap(code);
    p.frame(2);
    EXPECT_FALSE(p.rects.contains("menu.file.open")) << code;
  }
}

TEST_F(Keyboard, MenusAreWalkedWithTheArrows) {
  p.tap(key::kF1 + 9);
  p.frame(3);
  p.tap(key::kEnter);  // the first entry
  p.frame(4);
  EXPECT_TRUE(state().browser.show);
  p.tap(key::kEscape);
  p.frame(2);
  p.tap(key::kF1 + 9);
  p.frame(3);
  p.tap(key::kRight);
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("menu.edit.undo"));
  EXPECT_FALSE(p.rects.contains("menu.file.open"));
  p.tap(key::kLeft);
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("menu.file.open"));
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0);
  p.tap(key::kLeft);
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("menu.help.about")) << "round about";
}

TEST_F(Keyboard, AltWithSomethingElseOpensNothing) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeysDown[key::kLeftAlt] = true;
  p.frame();
  p.tap(key::kTab);  // to another program
  io.KeysDown[key::kLeftAlt] = false;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("menu.file.open"));
  io.KeysDown[key::kLeftAlt] = true;
  p.frame();
  p.click("alpha.preset.3");
  io.KeysDown[key::kLeftAlt] = false;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("menu.file.open"));
  io.KeysDown[key::kLeftAlt] = true;
  p.frame();
  io.AddFocusEvent(false);
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("menu.file.open"));
}

// --- dialogs

TEST_F(Keyboard, ASaveDialogBeginsWithTheNameAndEnterSaves) {
  state().dialogs.show_save = true;
  state().dialogs.save_path = "/tmp/alphascope first.png";
  p.frame(4);
  EXPECT_EQ(at(), "save.path");
  letters("other");  // only the name is replaced
  EXPECT_EQ(state().dialogs.save_path, "/tmp/other.png");
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->path, "/tmp/other.png");
  EXPECT_FALSE(state().dialogs.show_save);
}

TEST_F(Keyboard, WhatTheProgramSetsInAFieldThatIsTypedIntoStays) {
  state().dialogs.show_save = true;
  p.frame(4);
  letters("typed");
  state().dialogs.save_path = "/tmp/set.png";
  p.frame(3);
  EXPECT_EQ(state().dialogs.save_path, "/tmp/set.png");
}

TEST_F(Keyboard, EscapeClosesADialogAtOnceUnlessSomethingWasTyped) {
  state().dialogs.show_save = true;
  p.frame(4);
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(state().dialogs.show_save);
  state().dialogs.show_save = true;
  p.frame(4);
  letters("other");
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_TRUE(state().dialogs.show_save) << "it takes back what was typed";
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(state().dialogs.show_save);
}

TEST_F(Keyboard, EveryDialogConfirmsWithEnterAndTakesTheFocusBack) {
  ASSERT_TRUE(tab_to("alpha.preset.3"));
  p.state.show_error("The file cannot be opened", "x.pdb, line 3: no number.", ErrorKind::input);
  p.frame(4);
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(p.state.error.empty());
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0) << "not the button below";
  EXPECT_EQ(at(), "alpha.preset.3");
  p.state.molecule.assemblies = {{"1", "", 60, 1000000, 1}};
  state().dialogs.confirm_assembly = "1";
  p.frame(4);
  p.tap(key::kEnter);
  EXPECT_EQ(p.state.settings.open.assembly, "1");
  p.state.session_problem = SessionProblem{"a.json", "gone", true, false};
  p.frame(4);
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(state().browser.show);
}

TEST_F(Keyboard, EnterPressesTheButtonThatTabCameToInADialog) {
  state().dialogs.show_export = true;
  state().dialogs.export_path = "/tmp/a.stl";
  p.frame(4);
  ASSERT_TRUE(tab_to("export.cancel"));
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_FALSE(state().dialogs.show_export);
  EXPECT_FALSE(p.asked.export_complex);
}

TEST_F(Keyboard, EnterDoesNotConfirmWhatCannotBe) {
  state().dialogs.show_export = true;
  state().dialogs.export_path = "/no/such/folder/a.stl";
  p.frame(4);
  p.tap(key::kEnter);
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(state().dialogs.show_export);
  EXPECT_FALSE(p.asked.export_complex);
}

TEST_F(Keyboard, EnterInANumberOrAColourConfirmsTheDialog) {
  const auto open = [&] {
    p.asked.screenshot.reset();
    state().dialogs.save_path = "/tmp/a.png";
    state().dialogs.show_save = true;
    p.frame(4);
  };
  open();
  ASSERT_TRUE(tab_to("save.width"));
  letters("640");
  p.tap(key::kEnter);
  p.frame(2);
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->options.width, 640);
  EXPECT_FALSE(state().dialogs.show_save);
  open();
  ASSERT_TRUE(tab_to("save.height"));
  p.tap(key::kEnter);
  EXPECT_TRUE(p.asked.screenshot) << "of an unchanged number, too";
  open();
  ASSERT_TRUE(tab_to("save.background"));
  letters("FF8000");
  p.tap(key::kEnter);
  p.frame(2);
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->options.background.colour, (Rgb8{255, 128, 0}));
  // A wrong number is not saved. Enter leads back into it.
  open();
  ASSERT_TRUE(tab_to("save.width"));
  letters("99999");
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_FALSE(p.asked.screenshot);
  EXPECT_TRUE(p.rects.contains("save.width.error"));
  EXPECT_EQ(at(), "save.width");
  EXPECT_TRUE(marked());
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(typing());
  letters("320");
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->options.width, 320);
}

TEST_F(Keyboard, EnterInTheBenchmarksFieldsRunsIt) {
  state().dialogs.show_benchmark = true;
  p.frame(4);
  ASSERT_TRUE(tab_to("benchmark.runs"));
  letters("x");
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_FALSE(p.asked.run_benchmark) << "not with the number before";
  p.tap(key::kEnter);
  p.frame(2);
  letters("2");
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(p.asked.run_benchmark);
  EXPECT_EQ(state().benchmark_settings.runs, 2);
  p.asked.run_benchmark = false;
  ASSERT_TRUE(tab_to("benchmark.alphas"));
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(p.asked.run_benchmark);
}

// The digits and the patch of a colour are stops, wherever there is such a field.
TEST_F(Keyboard, TabGoesThroughAColour) {
  p.state.settings.display.ball_paint =
      with_scheme(p.state.settings.display.ball_paint, ColourBy::single);
  p.frame(2);
  EXPECT_TRUE(tab_to("display.ball_one_colour"));
  state().dialogs.show_save = true;
  p.frame(4);
  p.click("save.background", 0.3f);
  EXPECT_EQ(at(), "save.background");
  tab();
  EXPECT_EQ(at(), "save.background.patch");
  tab();
  EXPECT_EQ(at(), "save.letters");
  back();
  back();
  p.frame();
  EXPECT_TRUE(typing());
  letters("00FF00");
  tab();
  EXPECT_EQ(p.state.window.picture.background.colour, (Rgb8{0, 255, 0}));
  p.tap(key::kSpace);
  p.frame(3);
  EXPECT_TRUE(state().keys.list_open) << "the picker";
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(state().keys.list_open);
  EXPECT_TRUE(state().dialogs.show_save);
}

// --- a path in the file dialog

class TypedPath : public Keyboard {
 protected:
  TypedPath()
      : folder_(fs::temp_directory_path() / ("alphascope_typed_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "inside");
    for (const char* name : {"a.pdb", "b.pdb", "inside/deep.pdb", "inside/other.pdb"}) {
      std::ofstream(folder_ / name) << "x";
    }
    state().browser.folder = "/";
    state().browser.show = true;
    list();
  }
  ~TypedPath() override { fs::remove_all(folder_); }
  void list() {
    p.frame(2);
    if (const auto wanted = wanted_listing(state().browser)) {
      p.state.listing = std::make_shared<const FolderListing>(list_folder(*wanted));
    }
    p.frame(3);
  }

  fs::path folder_;
};

TEST_F(TypedPath, IsBegunWithASlashAndListed) {
  letters((folder_ / "inside" / "o").string());
  EXPECT_EQ(state().browser.typed, (folder_ / "inside" / "o").string());
  list();
  EXPECT_TRUE(p.rects.contains("browser.entry.deep.pdb"));
  EXPECT_EQ(state().browser.selected, folder_ / "inside" / "other.pdb");
  letters("ther.pdb");
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(*p.asked.open, folder_ / "inside" / "other.pdb");
}

TEST_F(TypedPath, OfAFolderGoesIntoItAndArrowsLeadIntoTheList) {
  letters(folder_.string());
  p.tap(key::kEnter);
  EXPECT_EQ(state().browser.folder, folder_);
  EXPECT_TRUE(state().browser.show);
  list();
  letters((folder_ / "a").string());
  list();
  p.tap(key::kDown);
  EXPECT_EQ(state().browser.typed, (folder_ / "b.pdb").string());
  p.frame();
  EXPECT_FALSE(typing());
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(*p.asked.open, folder_ / "b.pdb");
}

TEST_F(TypedPath, IsPasted) {
  ImGuiIO& io = ImGui::GetIO();
  ImGui::SetClipboardText(((folder_ / "a.pdb").string() + "\n").c_str());
  io.KeyCtrl = true;
  p.tap(key::kV);
  io.KeyCtrl = false;
  p.frame(2);
  EXPECT_EQ(state().browser.typed, (folder_ / "a.pdb").string());
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(*p.asked.open, folder_ / "a.pdb");
}

TEST_F(TypedPath, ThatIsWrongIsSaid) {
  letters("/no such folder/x");
  EXPECT_EQ(state().browser.error, "There is no folder /no such folder.");
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_TRUE(state().browser.show);
  EXPECT_TRUE(p.rects.contains("browser.error"));
}

TEST_F(TypedPath, RelativeToTheFolderThatWasOpen) {
  letters(folder_.string());
  p.tap(key::kEnter);
  list();
  tab();
  back();
  ASSERT_EQ(at(), "browser.path");
  p.frame();
  letters("inside/d");  // Tab has selected all of it
  list();
  EXPECT_EQ(state().browser.selected, folder_ / "inside" / "deep.pdb");
  letters("eep.pdb");
  p.tap(key::kEnter);
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(fs::weakly_canonical(*p.asked.open),
            fs::weakly_canonical(folder_ / "inside" / "deep.pdb"));
}

}  // namespace
}  // namespace alphascope::testing
