// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how texts of lessons are read, and the messages for wrong ones.
#include "core/document/lessons/lesson.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/document/lessons/lesson_facts.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/store/answer.hpp"
#include "core/engine/engine.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLesson = R"(# Two balls

What happens
between them.

```
molecule two.xyzr
view.from z      # not a comment here
# a comment
```

## They **overlap**

First line
goes on with **bold** words.

- an item
  that goes on
- another

A second paragraph.

```
alpha.set 1.4
```

## Question

```
molecule other/three.xyzr
```

How many?

### Answer

```
alpha.set 2
```

{n edges} at {alpha}.
)";

Lesson lesson() {
  return read_lesson(kLesson, "/lessons/two.md");
}

TEST(Lesson, HasTitleSummaryAndSteps) {
  const Lesson read = lesson();
  EXPECT_EQ(read.title, "Two balls");
  EXPECT_EQ(read.summary, "What happens between them.");
  ASSERT_EQ(read.commands.size(), 1u);
  EXPECT_EQ(read.commands[0].text, "view.from z      # not a comment here");
  EXPECT_EQ(read.commands[0].line, 8u);
  ASSERT_EQ(read.steps.size(), 2u);
  const LessonStep& first = read.steps[0];
  EXPECT_EQ(first.title, "They **overlap**");
  EXPECT_EQ(first.line, 12u);
  ASSERT_EQ(first.shown.text.size(), 4u);
  EXPECT_EQ(first.shown.text[0].text, "First line goes on with **bold** words.");
  EXPECT_EQ(first.shown.text[1].text, "an item that goes on");
  EXPECT_TRUE(first.shown.text[2].item);
  EXPECT_FALSE(first.shown.text[3].item);
  ASSERT_EQ(first.shown.commands.size(), 1u);
  EXPECT_EQ(first.shown.commands[0].line, 24u);
  EXPECT_FALSE(first.asks());
}

TEST(Lesson, AQuestionHasAnAnswerWithCommandsOfItsOwn) {
  const Lesson read = lesson();
  const LessonStep& question = read.steps.at(1);
  ASSERT_TRUE(question.asks());
  EXPECT_TRUE(question.shown.commands.empty());
  ASSERT_EQ(question.answer.commands.size(), 1u);
  EXPECT_EQ(question.answer.commands[0].text, "alpha.set 2");
}

TEST(Lesson, MoleculesAreBesideTheLesson) {
  const Lesson read = lesson();
  EXPECT_EQ(read.molecule_of(read.steps[0]), fs::path("/lessons/two.xyzr"));
  EXPECT_EQ(read.molecule_of(read.steps[1]), fs::path("/lessons/other/three.xyzr"));
}

TEST(Lesson, BoldWordsAreSpans) {
  const auto spans = lesson_spans("a **b c** d");
  ASSERT_EQ(spans.size(), 3u);
  EXPECT_EQ(spans[0].text, "a ");
  EXPECT_TRUE(spans[1].bold);
  EXPECT_EQ(spans[1].text, "b c");
  EXPECT_EQ(spans[2].text, " d");
}

// The text with one part replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = kLesson;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) ADD_FAILURE() << from;
  return text.replace(at, from.size(), to);
}

std::string fault(const std::string& text) {
  try {
    read_lesson(text, "two.md");
  } catch (const ReadError& error) {
    return error.what();
  }
  return "";
}

TEST(Lesson, FaultsHaveFileLineAndReason) {
  EXPECT_EQ(fault(kLesson), "");
  EXPECT_EQ(fault(""), "two.md: the title is missing. Begin with a line such as # My lesson.");
  EXPECT_EQ(fault("text\n"),
            "two.md, line 1: the title is missing. Begin with a line such as # My lesson.");
  EXPECT_EQ(fault("# Title\nsummary\n"),
            "two.md: there is no step. Begin one with a line such as ## Two balls.");
  EXPECT_EQ(fault(with("What happens\nbetween them.", "")),
            "two.md, line 11: the summary is missing. Say in a line below the title what the "
            "lesson is about.");
  EXPECT_EQ(fault(with("## Question", "#### Question")),
            "two.md, line 27: \"#### Question\" is no heading of a lesson. A lesson has # Title, "
            "## Step and ### Answer.");
  EXPECT_EQ(fault(with("## Question", "# Question")),
            "two.md, line 27: there is a second title. Begin steps with ##.");
  EXPECT_EQ(fault(with("How many?", "")),
            "two.md, line 35: there is an answer and no question. Write the question.");
  EXPECT_EQ(fault(with("{n edges} at {alpha}.", "")),
            "two.md, line 35: the answer is empty. Write it.");
  EXPECT_EQ(fault(with("{n edges}", "{edge}"))
                .find("two.md, line 41: there is no fact \"edge\". "
                      "The facts are alpha, "),
            0u);
  EXPECT_EQ(fault(with("{alpha}.", "{alpha")),
            "two.md, line 41: a { has no }. Write facts as in {tetrahedra}.");
  EXPECT_EQ(fault(with("molecule two.xyzr", "")),
            "two.md, line 12: the step has no molecule. Name a file in its commands, such as "
            "molecule two_balls.xyzr.");
  EXPECT_EQ(fault(with("alpha.set 2\n```", "alpha.set 2\n")),
            "two.md, line 37: the commands do not end. End them with a line of ```.");
  EXPECT_EQ(fault(with("alpha.set 2", "molecule two.xyzr")),
            "two.md, line 38: an answer has another molecule. Begin a step for it.");
  EXPECT_EQ(fault(with("How many?", "How \x1b[31m many?")),
            "two.md, line 33: it has characters that cannot be shown. Write it as plain text in "
            "UTF-8.");
  EXPECT_EQ(fault(with("How many?", "## Empty")),
            "two.md, line 27: the step has no text. Write below the heading what the step shows.");
}

TEST(Lesson, LimitsAreKept) {
  std::string steps = "# T\nS\n```\nmolecule a.xyzr\n```\n";
  for (std::size_t k = 0; k <= kMostLessonSteps; ++k) steps += "## Step\ntext\n";
  EXPECT_NE(fault(steps).find("more than 100 steps"), std::string::npos);
  std::string commands = "# T\nS\n## Step\ntext\n```\nmolecule a.xyzr\n";
  for (std::size_t k = 0; k <= kMostLessonCommands; ++k) commands += "alpha.set 1\n";
  EXPECT_NE(fault(commands + "```\n").find("more than 50 commands"), std::string::npos);
  EXPECT_NE(fault(std::string(kLargestLesson + 1, 'x')).find("larger than a lesson"),
            std::string::npos);
}

TEST(Lesson, TheExampleOfTheDocsIsOne) {
  std::ifstream file(fs::path(ALPHASCOPE_SOURCE_DIR) / "docs/file-formats.md");
  const std::string docs{std::istreambuf_iterator<char>(file), {}};
  const std::string begin = "````\n# ", end = "\n````\n";
  const std::size_t from = docs.find(begin), to = docs.find(end, from);
  ASSERT_NE(to, std::string::npos);
  const std::string example = docs.substr(from + 5, to - from - 4);
  const Lesson read = read_lesson(example, "example.md");
  EXPECT_EQ(read.steps.size(), 2u);
  EXPECT_TRUE(read.steps.back().asks());
}

TEST(LessonFacts, NamesAreChecked) {
  for (const char* name :
       {"alpha", "edges", "n edges", "all tetrahedra", "n all edges", "hidden", "saturated",
        "grown #2", "value #1", "value #1 #2 #3 #4", "voids", "volume"}) {
    EXPECT_TRUE(is_lesson_fact(name)) << name;
  }
  for (const char* name : {"", "edge", "n", "n alpha", "all alpha", "all", "edges #1", "grown",
                           "grown 1", "grown #0", "value", "value #1 #2 #3 #4 #5", "value #x",
                           "value #99999999999999999999999", "n all", "all n edges"}) {
    EXPECT_FALSE(is_lesson_fact(name)) << name;
  }
}

// Balls of radius 2 Å, with all facts but those of cavities.
LessonFacts facts_of(const std::vector<LatticePoint>& centres, double alpha) {
  auto balls = std::make_shared<BallSet>();
  balls->centres = centres;
  balls->radii.assign(centres.size(), 2000);
  auto prepared = std::make_shared<PreparedBalls>();
  prepared->balls = balls;
  for (std::uint32_t k = 0; k < centres.size(); ++k) prepared->atom_of_ball.push_back(k);
  auto answer = std::make_shared<Answer>();
  answer->request.alpha_angstrom2 = alpha;
  answer->balls = balls;
  answer->prepared = prepared;
  answer->complex = make_cgal_engine(balls)->compute({alpha}, {});
  LessonFacts facts{answer, {}, {}, {}};
  facts.all = [balls] {
    return std::make_shared<const Filtration>(balls, make_triangulation(*balls, 1));
  };
  facts.measured = [answer] {
    return std::make_shared<const MeasuredComplex>(
        measure_complex(*answer->balls, answer->complex, nullptr, {}));
  };
  return facts;
}

TEST(LessonFacts, AreThoseOfTheComplex) {
  const LessonFacts facts = facts_of({{0, 0, 0}, {3000, 0, 0}}, -1.75);
  EXPECT_EQ(
      with_facts("{balls} {alpha} {solvent} {vertices} {n edges} {n triangles} {euler}", facts),
      "2 −1.75 Å² 0 Å 2 1 edge no triangles 1");
  EXPECT_EQ(with_facts("{value #2} {value #2 #1} {grown #1} {hidden}", facts),
            "−4 Å² −1.75 Å² 1.5 Å 0");
  EXPECT_EQ(with_facts("{value #3} {grown #3} {voids} {components}", facts), "none … … 1");
  const LessonFacts at_0 = facts_of({{0, 0, 0}, {3000, 0, 0}}, 0);
  // Two balls less their common lens, which is two caps of height 0.5 Å.
  EXPECT_EQ(with_facts("{volume}", at_0), "64.141 Å³");
}

// The corners of the middle ball's cell are √27 Å away, so they have the power 27 − 4 = 23 Å².
TEST(LessonFacts, CountSaturatedBalls) {
  const std::vector<LatticePoint> centres{{0, 0, 0},
                                          {2000, 2000, 2000},
                                          {2000, -2000, -2000},
                                          {-2000, 2000, -2000},
                                          {-2000, -2000, 2000}};
  EXPECT_EQ(with_facts("{saturated} of {balls}", facts_of(centres, 22.9)), "0 of 5");
  EXPECT_EQ(with_facts("{saturated} of {balls}", facts_of(centres, 23)), "1 of 5");
}

TEST(LessonFacts, OfAFlatSetHaveNoTetrahedra) {
  const LessonFacts facts = facts_of({{0, 0, 0}, {2000, 0, 0}, {0, 2000, 0}, {2000, 2000, 0}}, 100);
  EXPECT_EQ(with_facts("{n all edges} {n all triangles} {n tetrahedra} {n all tetrahedra}", facts),
            "5 edges 2 triangles no tetrahedra no tetrahedra");
}

TEST(LessonFacts, OfTetrahedraAloneSayNoMore) {
  LessonFacts facts = facts_of({{0, 0, 0}, {3000, 0, 0}}, 0);
  auto only = std::make_shared<Answer>(*facts.shown);
  only->complex = make_cgal_engine(only->balls)->compute({0, true}, {});
  facts.shown = only;
  EXPECT_EQ(with_facts("{tetrahedra} {edges} {saturated} {alpha}", facts), "0 … … 0 Å²");
}

TEST(LessonFacts, WhatIsNotKnownIsDots) {
  EXPECT_EQ(with_facts("{edges} of {value #1 #2}, {no fact", {}), "… of …, {no fact");
}

}  // namespace
}  // namespace alphascope
