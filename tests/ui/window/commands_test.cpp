// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the list of commands in menus, keys, the palette, the cheat sheet and scripts.
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "app/viewer/commands/commands.hpp"
#include "core/document/commands/command_search.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/no_calls.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using testing::crambin;
using testing::loaded_state;
using testing::Panels;

std::vector<CommandSpec> program_commands() {
  static WholeState state = loaded_state();
  Commands commands;
  NoCalls nobody;
  PanelSet panels;
  add_program_commands(commands, state, nobody.calls(), panels);
  return commands.all();
}

TEST(CommandList, EveryCommandSaysWhatItIs) {
  const std::vector<CommandSpec> specs = program_commands();
  ASSERT_GT(specs.size(), 30u);
  std::set<std::string> titles;
  for (const CommandSpec& spec : specs) {
    EXPECT_NE(spec.id.find('.'), std::string::npos) << spec.id << ": words without are scripts'";
    EXPECT_TRUE(titles.insert(spec.title).second) << spec.title;
    EXPECT_NE(spec.help, spec.title);
    EXPECT_NE(spec.help.back(), '.') << spec.id;
    for (const Parameter& p : spec.parameters) EXPECT_FALSE(p.help.empty()) << spec.usage();
  }
}

TEST(CommandList, EveryShortcutIsAKeyInOneSpelling) {
  ASSERT_GT(program_commands().size(), 30u);
  for (const CommandSpec& spec : program_commands()) {
    for (const Shortcut& shortcut : spec.shortcuts) {
      const auto chord = key::read_chord(shortcut.keys);
      ASSERT_TRUE(chord) << shortcut.keys;
      EXPECT_EQ(shortcut.keys.find(' '), std::string::npos) << shortcut.keys;
      EXPECT_EQ(chord->control, shortcut.keys.starts_with("Ctrl+")) << shortcut.keys;
      EXPECT_FALSE(std::islower(static_cast<unsigned char>(shortcut.keys[0]))) << shortcut.keys;
      const CommandLine line = Commands::parse_words(spec, shortcut.arguments);
      const Commands::Reading reading = Commands::read(spec, line.words);
      EXPECT_TRUE(reading.error.empty()) << reading.error;
    }
  }
}

TEST(CommandList, TheUserGuideNamesEveryShortcut) {
  ASSERT_GT(program_commands().size(), 30u);
  std::ifstream file(std::string(ALPHASCOPE_SOURCE_DIR) + "/docs/guide/window.md");
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  for (const CommandSpec& spec : program_commands()) {
    for (const Shortcut& shortcut : spec.shortcuts) {
      EXPECT_NE(guide.find("`" + shortcut.keys + "`"), std::string::npos) << shortcut.keys;
    }
  }
}

TEST(CommandList, WhatPeopleCallThingsIsFound) {
  static WholeState state = loaded_state();
  Commands commands;
  NoCalls nobody;
  PanelSet panels;
  add_program_commands(commands, state, nobody.calls(), panels);
  const std::pair<const char*, const char*> expected[] = {
      {"pocket", "view.page cavities"}, {"hole", "view.page cavities"},
      {"tunnel", "view.page channels"}, {"volume", "view.page measures"},
      {"image", "file.save_picture "},  {"picture", "file.save_picture "},
      {"movie", "file.record "},        {"surface", "view.boundary "},
      {"mesh", "file.export "}};
  for (const auto& [typed, best] : expected) {
    const auto found = search_commands(commands, typed);
    ASSERT_FALSE(found.empty()) << typed;
    EXPECT_EQ(found[0].command->id + " " + found[0].arguments, best) << typed;
  }
}

TEST(CommandList, EveryPageBelowTheViewIsInAMenu) {
  const std::vector<CommandSpec> specs = program_commands();
  const auto page = std::find_if(specs.begin(), specs.end(),
                                 [](const CommandSpec& spec) { return spec.id == "view.page"; });
  ASSERT_NE(page, specs.end());
  EXPECT_EQ(page->menu, "View");
  std::set<std::string> listed;
  for (const Choice& choice : page->parameters.at(0).choices()) listed.insert(choice.id);
  for (const PanelSpec& panel : panels()) {
    EXPECT_EQ(listed.contains(panel.id), panel.place == PanelPlace::bottom) << panel.id;
  }
}

TEST(KeyNames, AreRead) {
  const auto chord = key::read_chord("Ctrl+Shift+Z");
  ASSERT_TRUE(chord);
  EXPECT_EQ(chord->code, key::kZ);
  EXPECT_TRUE(chord->control && chord->shift);
  EXPECT_EQ(key::read_chord("escape")->code, key::kEscape);
  EXPECT_EQ(key::read_chord("f12")->code, key::kF1 + 11);
  for (const char* wrong : {"", "Ctrl+", "Alt+X", "F13", "Z+Ctrl", "ä"}) {
    EXPECT_FALSE(key::read_chord(wrong)) << wrong;
  }
}

class CommandsInPanels : public ::testing::Test {
 protected:
  CommandsInPanels() {
    p.state = loaded_state();
    p.frame(2);
  }
  void chord(int code, bool shift = false) {
    ImGui::GetIO().KeyCtrl = true;
    ImGui::GetIO().KeyShift = shift;
    p.tap(code);
    ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeyShift = false;
    p.frame(2);
  }
  void open_palette() {
    chord(key::kP);
    p.frame(2);
    EXPECT_TRUE(p.rects.contains("palette.field"));
  }
  void type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    p.frame(2);
  }
  // Types over the field's content.
  void type_anew(const std::string& text) {
    chord(key::kA);
    type(text);
  }
  void enter() {
    p.tap(key::kEnter);
    p.frame(3);
  }
  bool is_open() { return p.rects.contains("palette.field"); }
  const PaletteState& palette() const { return p.state.palette; }

  Panels p{{1280, 800, 1}};
};

TEST_F(CommandsInPanels, ANewCommandIsOneRegistration) {
  int count = 0;
  p.commands.add({.id = "test.count",
                  .title = "Count sheep",
                  .help = "One more",
                  .shortcuts = {{"Ctrl+Shift+K"}},
                  .menu = "Edit",
                  .run = [&](const Arguments&) {
                    ++count;
                    return Outcome();
                  }});
  p.frame(2);
  p.click("menu.Edit");
  p.click("menu.test.count");
  EXPECT_EQ(count, 1);
  chord(key::kA + 'K' - 'A', true);
  EXPECT_EQ(count, 2);
  chord(key::kA + 'K' - 'A');
  EXPECT_EQ(count, 2) << "without Shift";
  open_palette();
  type("sheep");
  enter();
  EXPECT_EQ(count, 3);
  EXPECT_TRUE(p.commands.run_line("test.count").done());
  EXPECT_EQ(count, 4);
}

TEST_F(CommandsInPanels, AFailureIsTold) {
  p.commands.add({.id = "test.fail",
                  .title = "Fail",
                  .help = "Always",
                  .shortcuts = {{"Ctrl+Shift+K"}},
                  .run = [](const Arguments&) { return Outcome::failed("The disk is full."); }});
  chord(key::kA + 'K' - 'A', true);
  EXPECT_EQ(p.state.error, "The disk is full.");
}

TEST_F(CommandsInPanels, MenusHaveOneOrderAndAnEmptyOneIsNotThere) {
  p.commands = {};
  for (const char* menu : {"Help", "View", "File"}) {
    p.commands.add({.id = std::string("test.") + menu,
                    .title = menu,
                    .help = "Nothing",
                    .menu = menu,
                    .run = [](const Arguments&) { return Outcome(); }});
  }
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("menu.Edit"));
  float right = 0;
  for (const char* name : {"menu.File", "menu.View", "menu.Help"}) {
    ASSERT_TRUE(p.rects.contains(name)) << name;
    EXPECT_GE(p.rects[name].x0, right) << name;
    right = p.rects[name].x1;
  }
}

TEST_F(CommandsInPanels, WhatCannotRunIsGreyedAndSaysWhy) {
  p.state.molecule.loaded = false;
  p.click("menu.View");
  p.click("menu.view.reset");
  EXPECT_FALSE(p.asked.reset_view);
  EXPECT_TRUE(p.rects.contains("menu.view.reset")) << "a greyed entry leaves the menu open";
  p.tap(key::kEscape);
  p.tap(key::kR);
  EXPECT_FALSE(p.asked.reset_view);
  open_palette();
  type("reset");
  enter();
  EXPECT_TRUE(is_open());
  EXPECT_EQ(palette().error, "No molecule is open.");
  EXPECT_TRUE(p.rects.contains("palette.error"));
  EXPECT_FALSE(p.asked.reset_view);
  p.state.molecule.loaded = true;
  enter();
  EXPECT_TRUE(p.asked.reset_view);
  EXPECT_FALSE(is_open());
}

TEST_F(CommandsInPanels, ASubmenuChoosesTheSample) {
  p.click("menu.File");
  p.click("menu.file.sample");
  p.frame(3);
  p.click("menu.file.sample.crambin");
  ASSERT_TRUE(p.asked.open);
  EXPECT_EQ(*p.asked.open, "1crn.pdb");
}

TEST_F(CommandsInPanels, AMenuEntryThatNeedsANumberAsksForIt) {
  p.click("menu.Tools");
  p.click("menu.alpha.set");
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("palette.asks"));
  type("2,5 Å²");
  enter();
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 2.5);
  EXPECT_FALSE(is_open());
}

TEST_F(CommandsInPanels, ThePaletteRunsWhatIsTypedWithItsArguments) {
  open_palette();
  type("alpha 3.2");
  enter();
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3.2);
  EXPECT_FALSE(is_open());
  p.click("alpha.preset.10");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 10)
      << "the mouse is the window's again";
  p.tap(key::kLeft);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 9.9) << "and so are the keys";
}

TEST_F(CommandsInPanels, AnErrorKeepsThePaletteOpen) {
  open_palette();
  type("solvent 200");
  enter();
  EXPECT_TRUE(is_open());
  EXPECT_NE(palette().error.find("between 0 and 100 Å"), std::string::npos) << palette().error;
  type_anew("solvent 1.4");
  EXPECT_TRUE(palette().error.empty());
  enter();
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.4);
  open_palette();
  type("/no/such/file.pdb");
  enter();
  EXPECT_TRUE(palette().show);
  type_anew("open /no/such/file.pdb");
  enter();
  EXPECT_EQ(palette().error, "There is no file /no/such/file.pdb.");
}

TEST_F(CommandsInPanels, MissingArgumentsAreAskedFor) {
  open_palette();
  type("solvent");
  enter();
  EXPECT_EQ(palette().asking, "solvent.set");
  EXPECT_TRUE(p.rects.contains("palette.asks"));
  type("wide");
  enter();
  EXPECT_NE(palette().error.find("“wide” is not a number"), std::string::npos) << palette().error;
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_TRUE(palette().asking.empty()) << "back to the list";
  EXPECT_TRUE(is_open());
  type("solvent");
  enter();
  type("1.6");
  enter();
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.6);
  EXPECT_FALSE(is_open());
}

TEST_F(CommandsInPanels, AChoiceIsMadeWithTheArrowKeys) {
  open_palette();
  type("choose engine");
  enter();
  EXPECT_TRUE(p.rects.contains("palette.choice.cgal"));
  type("cpu");
  EXPECT_FALSE(p.rects.contains("palette.choice.cgal"));
  p.tap(key::kDown);
  enter();
  EXPECT_EQ(p.state.settings.request.engine, EngineChoice::tuples_cpu);
  EXPECT_FALSE(is_open());
  open_palette();
  type("choose engine gpu");
  p.state.gpu = GpuDevice{};
  p.state.gpu->why_not = "No CUDA driver.";
  enter();
  EXPECT_EQ(palette().error, "No CUDA driver.");
  EXPECT_EQ(p.state.settings.request.engine, EngineChoice::tuples_cpu);
}

// The message is right below the field in every frame.
TEST_F(CommandsInPanels, ThatNothingMatchesIsSaid) {
  open_palette();
  for (const bool choice : {false, true}) {
    if (choice) {
      type_anew("choose engine");
      enter();
    }
    type("qwx zz 99");
    p.frame(10);
    ASSERT_TRUE(p.rects.contains("palette.none"));
    const WidgetRect field = p.rects.at("palette.field"), none = p.rects.at("palette.none");
    EXPECT_LT(none.y1 - field.y1, 3 * (field.y1 - field.y0));
    enter();
    EXPECT_TRUE(is_open());
  }
}

TEST_F(CommandsInPanels, ArrowKeysAndTheMouseChooseARow) {
  open_palette();
  type("theme");
  p.click("palette.view.light_theme");
  p.frame(2);
  EXPECT_EQ(p.state.window.theme, Theme::light);
  EXPECT_FALSE(is_open());
  open_palette();
  EXPECT_TRUE(palette().typed.empty());
  p.tap(key::kDown);
  p.tap(key::kDown);
  p.tap(key::kUp);
  EXPECT_EQ(palette().chosen, 1u);
  p.tap(key::kUp);
  p.tap(key::kUp);
  EXPECT_EQ(palette().chosen, p.commands.all().size() - 1) << "round and round";
  EXPECT_TRUE(p.rects[("palette." + p.commands.all().back().id)].visible) << "scrolled into sight";
}

TEST_F(CommandsInPanels, EscapeAndAClickBesideCloseThePalette) {
  open_palette();
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(is_open());
  EXPECT_FALSE(p.asked.cancel);
  open_palette();
  p.click("view", 0.5f, 0.95f);
  p.frame(2);
  EXPECT_FALSE(is_open());
}

TEST_F(CommandsInPanels, AnErrorDialogComesAboveThePalette) {
  open_palette();
  type("bou");
  p.state.show_error("The file cannot be opened", "x.pdb, line 3: no number.", ErrorKind::input);
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("error.ok"));
  p.tap(key::kEscape);
  p.frame(4);
  EXPECT_TRUE(p.state.error.empty());
  EXPECT_TRUE(is_open()) << "Escape was the error's";
  EXPECT_EQ(palette().typed, "bou");
}

TEST_F(CommandsInPanels, NothingIsDispatchedWhileOneTypes) {
  open_palette();
  type("b");
  p.tap(key::kB);
  EXPECT_TRUE(p.state.settings.display.balls);
  p.tap(key::kEscape);
  p.frame(2);
  p.click("alpha.typed");
  p.tap(key::kB);
  EXPECT_TRUE(p.state.settings.display.balls);
}

TEST_F(CommandsInPanels, ThePaletteFitsASmallWindowAtTwiceTheSize) {
  Panels large({700, 500, 2});
  large.state = loaded_state();
  large.state.palette.show = true;
  large.frame(4);
  const WidgetRect field = large.rects.at("palette.field");
  EXPECT_GE(field.x0, 0);
  EXPECT_LE(field.x1, 1400);
}

// --- the program behind the panels

class CommandsInProgram : public testing::ViewerTest {
 protected:
  std::string error_of(const std::string& script) {
    try {
      run(script);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(CommandsInProgram, MenuKeyPaletteAndScriptDoTheSame) {
  open_crambin();
  const DisplaySettings& d = viewer_->state().settings.display;
  for (const char* way : {"view.edges\n", "key e\n", "click menu.View\nclick menu.view.edges\n",
                          "key ctrl+p\ntype edges\nkey enter\n"}) {
    const bool before = d.edges;
    run(way);
    EXPECT_NE(d.edges, before) << way;
  }
  run("view.edges on\nview.edges on\n");
  EXPECT_TRUE(d.edges);
  run("alpha.set 1.4\nwait-idle\n");
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(1.4).hash));
  run("solvent.set 1.4\nengine.set cgal\nalpha.step -0.4\nwait-idle\n");
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(1, 1.4).hash));
}

TEST_F(CommandsInProgram, ScriptsOpenAndSave) {
  const fs::path saved = folder_ / "a picture.png";
  run("file.open " + crambin().string() + "\nwait-idle\nfile.save_picture \"" + saved.string() +
      "\" 320 200 transparent\nwait-idle\n");
  EXPECT_EQ(viewer_->state().molecule.name, "1crn.pdb");
  EXPECT_TRUE(fs::exists(saved));
  run("file.sample haemoglobin\nwait-idle\n");
  EXPECT_EQ(viewer_->state().molecule.name, "4hhb.pdb.gz");
}

TEST_F(CommandsInProgram, AWrongLineIsExplained) {
  EXPECT_EQ(error_of("# nothing\nalpha.sett 1\n"),
            "test, line 2: unknown command 'alpha.sett'. Did you mean \"alpha.set\"?");
  EXPECT_EQ(error_of("clik view\n"),
            "test, line 1: unknown command 'clik'. Did you mean \"click\"?");
  EXPECT_EQ(error_of("alpha.set\n"),
            "test, line 1: alpha.set needs a number in Å², such as alpha.set 1.4");
  EXPECT_EQ(error_of("view.reset\n"), "test, line 1: No molecule is open.");
  EXPECT_EQ(error_of("key ctrl+\n"), "test, line 1: unknown key 'ctrl+'");
  EXPECT_EQ(error_of("when rings\n"),
            "test, line 1: when: \"rings\" is not one of dropped, guessed, chains, models, "
            "assemblies.");
  EXPECT_EQ(error_of("frames 1\nwhen chains\nnonsense\n"),
            "test, line 4: the last 'when' has no 'end'");
}

TEST_F(CommandsInProgram, TheHelpOfScriptsListsEverything) {
  const std::string help = script_help();
  for (const CommandSpec& spec : viewer_->commands().all()) {
    EXPECT_NE(help.find("\n  " + spec.usage()), std::string::npos) << spec.id;
  }
  for (const char* verb : {"move NAME [X] [Y]", "wait-idle", "shot PATH", "when dropped|guessed"}) {
    EXPECT_NE(help.find(std::string("\n  ") + verb), std::string::npos) << verb;
  }
}

}  // namespace
}  // namespace alphascope
