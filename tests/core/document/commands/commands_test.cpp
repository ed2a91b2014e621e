// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the list of commands: which entries it refuses, how lines are read, and how it is searched.
#include "core/document/commands/commands.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "core/document/commands/command_search.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;
using State = Outcome::State;
constexpr NumberRule kAlpha{"Alpha", -10, 100, "Å²"}, kWidth{"The width", 16, 4096, "", true};

class CommandsTest : public ::testing::Test {
 protected:
  CommandsTest() {
    add({.id = "view.reset",
         .title = "Reset view",
         .help = "Shows the whole molecule",
         .shortcuts = {{"R"}}});
    add({.id = "alpha.set",
         .title = "Set alpha…",
         .help = "Grows every ball",
         .parameters = {
             {.name = "alpha", .kind = Kind::number, .example = "1.4", .rule = kAlpha}}});
    add({.id = "alpha.step",
         .title = "Change alpha by",
         .help = "One step",
         .shortcuts = {{"Right", "0.1"}, {"Left", "-0.1"}},
         .parameters = {{.name = "step", .kind = Kind::number, .example = "0.1", .rule = kAlpha}}});
    add({.id = "file.open",
         .title = "Open…",
         .help = "Reads a molecule",
         .parameters = {{.name = "path", .kind = Kind::path, .optional = true}}});
    add({.id = "file.save",
         .title = "Save picture…",
         .help = "Writes a PNG file",
         .parameters = {{.name = "path", .kind = Kind::path, .example = "a.png"},
                        {.name = "width", .kind = Kind::number, .optional = true, .rule = kWidth},
                        {.name = "transparent", .kind = Kind::flag}}});
    add({.id = "engine.set",
         .title = "Choose engine",
         .help = "What computes",
         .parameters = {{.name = "engine", .kind = Kind::choice, .choices = [] {
                           return std::vector<Choice>{{"cpu", "CPU"}, {"gpu", "GPU"}};
                         }}}});
  }
  void add(CommandSpec spec) {
    if (!spec.run) {
      spec.run = [this, id = spec.id](const Arguments& arguments) {
        ran = id;
        given = arguments;
        return Outcome();
      };
    }
    commands.add(std::move(spec));
  }
  std::string why(const std::string& line) {
    const Outcome outcome = commands.run_line(line);
    EXPECT_EQ(outcome.state, State::refused) << line;
    EXPECT_EQ(ran, "") << line;
    return outcome.why;
  }
  void expect_run(const std::string& line, const std::string& id) {
    ran.clear();
    const Outcome outcome = commands.run_line(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.why;
    EXPECT_EQ(ran, id) << line;
  }
  std::string best(const std::string& typed) {
    const auto found = search_commands(commands, typed);
    if (found.empty()) return {};
    return found[0].command->id +
           (found[0].arguments.empty() ? "" : " <" + found[0].arguments + ">");
  }

  Commands commands;
  std::string ran;
  Arguments given;
};

TEST_F(CommandsTest, AnIdOrShortcutIsTakenOnce) {
  EXPECT_THROW(add({.id = "view.reset", .title = "Again", .help = "Again"}), std::logic_error);
  EXPECT_THROW(add({.id = "x.a", .title = "A", .help = "A", .shortcuts = {{"r"}}}),
               std::logic_error);
  EXPECT_THROW(add({.id = "x.a", .title = "A", .help = "A", .shortcuts = {{"Ctrl+Y"}, {"Ctrl+Y"}}}),
               std::logic_error);
  EXPECT_EQ(commands.find("x.a"), nullptr) << "what was refused is not there";
  add({.id = "x.a", .title = "A", .help = "A", .shortcuts = {{"Ctrl+R"}}});
  EXPECT_NE(commands.find("x.a"), nullptr);
}

TEST_F(CommandsTest, ASpecThatLacksSomethingIsRefused) {
  EXPECT_THROW(add({.id = "", .title = "A", .help = "A"}), std::logic_error);
  EXPECT_THROW(add({.id = "x.a", .title = "A", .help = ""}), std::logic_error);
  EXPECT_THROW(add({.id = "x.a",
                    .title = "A",
                    .help = "A",
                    .parameters = {{.name = "n", .kind = Kind::number}}}),
               std::logic_error);
  EXPECT_THROW(add({.id = "x.a",
                    .title = "A",
                    .help = "A",
                    .parameters = {{.name = "c", .kind = Kind::choice}}}),
               std::logic_error);
  EXPECT_THROW(add({.id = "x.a",
                    .title = "A",
                    .help = "A",
                    .parameters = {{.name = "a", .optional = true}, {.name = "b"}}}),
               std::logic_error);
  EXPECT_THROW(commands.add({.id = "x.a", .title = "A", .help = "A"}), std::logic_error);
}

TEST_F(CommandsTest, ALineRunsItsCommand) {
  expect_run("  view.reset  ", "view.reset");
  expect_run("alpha.set 1,4 Å²", "alpha.set");
  EXPECT_DOUBLE_EQ(given.number("alpha"), 1.4);
  expect_run("engine.set gpu", "engine.set");
  EXPECT_EQ(given.text("engine"), "gpu");
}

TEST_F(CommandsTest, PathsWithBlanks) {
  expect_run("file.open /my files/it's  here.pdb", "file.open");
  EXPECT_EQ(given.text("path"), "/my files/it's  here.pdb");
  expect_run("file.open \"/my files/a.pdb\"", "file.open");
  EXPECT_EQ(given.text("path"), "/my files/a.pdb");
  expect_run("file.open", "file.open");
  EXPECT_FALSE(given.has("path"));
  EXPECT_EQ(given.text("path", "none"), "none");
  expect_run("file.save 'my picture.png' 800 transparent", "file.save");
  EXPECT_EQ(given.text("path"), "my picture.png");
  EXPECT_DOUBLE_EQ(given.number("width"), 800);
  EXPECT_TRUE(given.has("transparent"));
  expect_run("file.save a.png transparent", "file.save");
  EXPECT_FALSE(given.has("width"));
  EXPECT_DOUBLE_EQ(given.number("width", 1920), 1920);
  EXPECT_TRUE(given.has("transparent"));
}

TEST_F(CommandsTest, WhatIsWrongIsSaid) {
  EXPECT_EQ(why("alpha.set"), "alpha.set needs a number in Å², such as alpha.set 1.4");
  EXPECT_EQ(why("alpha.set one"),
            "alpha.set: “one” is not a number. Write a number such as 1.4, in Å².");
  EXPECT_EQ(why("alpha.set 101"),
            "alpha.set: Alpha must lie between −10 and 100 Å²; “101” does not.");
  EXPECT_EQ(why("alpha.sett 1"), "There is no command \"alpha.sett\".");
  EXPECT_EQ(why("view.reset now"),
            "view.reset takes no arguments: \"now\" is too much. Write view.reset.");
  EXPECT_EQ(why("file.save a.png 800 600"),
            "file.save takes fewer arguments: \"600\" is too much. Write file.save PATH [WIDTH] "
            "[transparent].");
  EXPECT_EQ(why("file.save"), "file.save needs a path, such as file.save a.png");
  EXPECT_EQ(why("file.save \"a b.png 800"), "The quotes in \"\"a b.png 800\" do not end.");
  EXPECT_EQ(why("engine.set"), "engine.set needs one of cpu, gpu.");
  EXPECT_EQ(why("engine.set abacus"), "engine.set: \"abacus\" is not one of cpu, gpu.");
  EXPECT_EQ(why("file.save ''"), "file.save needs a path, such as file.save a.png");
}

TEST_F(CommandsTest, WhatCannotRunSaysWhyAndDoesNot) {
  std::string reason = "No molecule is open.";
  add({.id = "x.a", .title = "A", .help = "A", .why_not = [&] { return reason; }});
  EXPECT_EQ(why("x.a"), reason);
  reason.clear();
  expect_run("x.a", "x.a");
}

TEST_F(CommandsTest, WhatACommandThrowsIsItsFailure) {
  add({.id = "x.a", .title = "A", .help = "A", .run = [](const Arguments&) -> Outcome {
         throw std::runtime_error("the disk is full");
       }});
  add({.id = "x.b", .title = "B", .help = "B", .run = [](const Arguments&) -> Outcome {
         throw std::bad_alloc();
       }});
  const Outcome outcome = commands.run("x.a");
  EXPECT_EQ(outcome.state, State::failed);
  EXPECT_EQ(outcome.why, "the disk is full");
  EXPECT_EQ(commands.run("x.b").state, State::failed);
}

TEST_F(CommandsTest, SearchFindsByWordBeginningAndOrder) {
  EXPECT_EQ(search_commands(commands, "").size(), commands.all().size());
  EXPECT_EQ(best("reset"), "view.reset");
  EXPECT_EQ(best("RES vi"), "view.reset");
  EXPECT_EQ(best("rv"), "view.reset");
  EXPECT_EQ(best("view.reset"), "view.reset");
  EXPECT_EQ(best("molecule"), "view.reset") << "from the help, in the order of the list";
  EXPECT_EQ(best("open"), "file.open");
  EXPECT_EQ(best("reset xyzzy"), "");
}

TEST_F(CommandsTest, OneExampleIsGiven) {
  EXPECT_EQ((Parameter{.name = "alpha", .help = "Alpha", .example = "1.4", .rule = kAlpha})
                .what_to_type(),
            "Alpha, in Å², such as 1.4");
  EXPECT_EQ(
      (Parameter{.name = "step", .help = "Its name, such as grid", .example = "3"}).what_to_type(),
      "Its name, such as grid");
  EXPECT_EQ((Parameter{.name = "path", .help = "The file"}).what_to_type(), "The file");
}

TEST_F(CommandsTest, SearchFindsBySynonyms) {
  add({.id = "file.picture",
       .title = "Save it…",
       .help = "Writes a file",
       .synonyms = {{"image screenshot"}}});
  add({.id = "view.page",
       .title = "Page below",
       .help = "Shows one",
       .synonyms = {{"Cavities pocket", "cavities"}, {"Channels tunnel", "channels"}},
       .parameters = {
           {.name = "page", .kind = Kind::choice, .choices = [] {
              return std::vector<Choice>{{"cavities", "Cavities"}, {"channels", "Channels"}};
            }}}});
  EXPECT_EQ(best("image"), "file.picture");
  EXPECT_EQ(best("Screen"), "file.picture");
  EXPECT_EQ(best("save image"), "file.picture");
  EXPECT_EQ(best("pocket"), "view.page <cavities>");
  EXPECT_EQ(best("page tunnel"), "view.page <channels>");
  EXPECT_EQ(best("page"), "view.page") << "which one is asked";
  EXPECT_EQ(best("mage"), "") << "within a word there are too many";
  EXPECT_EQ(search_commands(commands, "").size(), commands.all().size());
}

TEST_F(CommandsTest, SearchTakesWhatFollowsAsArguments) {
  EXPECT_EQ(best("alpha 3.2"), "alpha.set <3.2>");
  EXPECT_EQ(best("alpha -3"), "alpha.set <-3>");
  EXPECT_EQ(best("step 0.2"), "alpha.step <0.2>");
  EXPECT_EQ(best("alpha 1000"), "alpha.set <1000>") << "it says what is wrong with that";
  EXPECT_EQ(best("alpha.set abc"), "alpha.set <abc>");
  EXPECT_EQ(best("open /my files/a b.pdb"), "file.open </my files/a b.pdb>");
  EXPECT_EQ(best("alpha +3"), "alpha.set <+3>");
  EXPECT_EQ(best("alpha .5"), "alpha.set <.5>");
  EXPECT_EQ(best("alpha −3"), "alpha.set <−3>") << "with a minus sign";
  EXPECT_EQ(best("alpha xyzzy"), "") << "that is neither a number nor anything else";
  EXPECT_EQ(best("engine gpu"), "engine.set <gpu>");
  EXPECT_EQ(best("engine abacus"), "");
}

}  // namespace
}  // namespace alphascope
