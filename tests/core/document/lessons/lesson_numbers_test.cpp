// SPDX-License-Identifier: GPL-3.0-or-later
// Tests numbers in the lessons' texts that are not facts of the complex on screen: the program
// computes the same ones. Also tests that texts fit into their column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/complex/alpha_complex.hpp"
#include "core/document/lessons/lesson.hpp"
#include "core/engine/engine.hpp"
#include "core/explain/explanation.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/support/keeping_engine.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

fs::path lessons() {
  return fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/lessons";
}

std::shared_ptr<const BallSet> balls_of(const std::string& name) {
  return prepare_balls(read_molecule(lessons() / name)).balls;
}

std::string text_of(const std::string& name) {
  std::ifstream file(lessons() / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A decimal text for values such as 0.000000133.
std::string decimals(double value, int count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", count, std::fabs(value));
  return text;
}

void expect_said(const std::string& text, const std::string& number) {
  EXPECT_NE(text.find(number), std::string::npos) << number;
}

TEST(LessonNumbers, ExactArithmetic) {
  const std::string text = text_of("10_exact_arithmetic.md");
  const std::vector<BallIndex> four{0, 1, 2, 3};
  const Explanation apart = explain(*balls_of("near_tie_apart.xyzr"), four, std::nullopt);
  ASSERT_EQ(apart.absence, AbsenceReason::none);
  ASSERT_EQ(apart.nearest.at(0).sign, 1);
  expect_said(text, "0.00485 Å²");
  EXPECT_EQ(decimals(apart.nearest[0].margin_angstrom2, 5), "0.00485");

  const Explanation tie = explain(*balls_of("near_tie.xyzr"), four, std::nullopt);
  ASSERT_NE(tie.absence, AbsenceReason::none);
  const BallMargin& margin = tie.nearest.at(0);
  EXPECT_EQ(margin.ball, 4u);
  EXPECT_EQ(margin.sign, -1);
  expect_said(text, "−" + decimals(margin.margin_angstrom2, 9) + " Å²");
  ASSERT_EQ(margin.steps.size(), 2u);
  const ArithmeticStep& single = margin.steps[0];
  EXPECT_GT(single.value_angstrom2, 0) << "single precision has the wrong sign";
  expect_said(text, "+" + decimals(single.value_angstrom2, 9) + " Å²");
  expect_said(text, decimals(single.error_angstrom2, 7) + " Å²");
  const ArithmeticStep& twice = margin.steps[1];
  EXPECT_LT(twice.value_angstrom2, 0);
  EXPECT_LT(twice.error_angstrom2, 1e-13);
}

// The corners of the middle ball's cell are 3.637 Å from it.
TEST(LessonNumbers, CornersOfACell) {
  const std::vector<BallIndex> middle{0};
  const Explanation cell = explain(*balls_of("five_balls.xyzr"), middle, std::nullopt);
  expect_said(text_of("12_whole_triangulation.md"), "3.637 Å");
  ASSERT_FALSE(cell.dual_edges_angstrom.empty());
  for (const auto& edge : cell.dual_edges_angstrom) {
    for (const RealPoint& end : edge)
      EXPECT_EQ(decimals(std::hypot(end.x, end.y, end.z), 3), "3.637");
  }
}

// The middle of an edge that does not appear by itself has the power 2² − 1² = 3 Å² for both its
// balls. For the third ball, 0.8 Å away, it has 0.8² − 1² = −0.36 Å².
TEST(LessonNumbers, AnAttachedEdge) {
  const std::vector<BallIndex> edge{0, 1};
  const Explanation e = explain(*balls_of("obtuse.xyzr"), edge, std::nullopt);
  expect_said(text_of("06_filtration.md"), "have the power 3 Å²");
  ASSERT_TRUE(e.orthosphere);
  EXPECT_NEAR(e.orthosphere->rho_angstrom2, 3, 1e-12);
  ASSERT_FALSE(e.nearest.empty());
  EXPECT_EQ(e.nearest[0].ball, 2u);
  EXPECT_NEAR(e.nearest[0].power_angstrom2, -0.36, 1e-12);
  EXPECT_TRUE(e.attached);
}

// Every nonempty set of balls gives a term.
TEST(LessonNumbers, TermsOfCrambin) {
  const std::size_t balls = balls_of("../molecules/1crn.pdb")->centres.size();
  EXPECT_EQ(balls, 327u);
  expect_said(text_of("01_union_of_balls.md"), "all 2³²⁷ − 1 terms");
}

// Tetrahedra of crambin at a large alpha. Where a lesson says that it shows the whole
// triangulation, its alpha gives all of them.
TEST(LessonNumbers, TheWholeOfCrambin) {
  const auto balls = balls_of("../molecules/1crn.pdb");
  const auto engine = testing::keeping(make_cgal_engine(balls));
  const auto tetrahedra = [&](double alpha) {
    return engine->compute({alpha}, {}).tetrahedra.size();
  };
  const std::size_t whole = tetrahedra(1e9);
  EXPECT_EQ(whole, tetrahedra(1e12));
  EXPECT_LT(tetrahedra(1e6), whole);
  EXPECT_GT(tetrahedra(10), whole / 2) << "most are inside, not far away";
  expect_said(text_of("03_power_diagram.md"), "alpha.set 1000000000\n");
}

// The part of a text between { and } that follows alpha.
std::string live_fact(const LessonPart& part) {
  constexpr std::string_view kSame[] = {"value", "balls", "hidden", "all", "n all"};
  for (const LessonParagraph& paragraph : part.text) {
    const std::string& text = paragraph.text;
    for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
      const std::string fact = text.substr(at + 1, text.find('}', at) - at - 1);
      const bool same = std::any_of(std::begin(kSame), std::end(kSame), [&](std::string_view one) {
        return fact == one || fact.starts_with(std::string(one) + " ");
      });
      if (!same) return fact;
    }
  }
  return {};
}

// A question is still shown above its answer. If the answer sets alpha, the question must not have
// numbers that follow alpha.
TEST(LessonTexts, AnswersLeaveTheNumbersOfTheirQuestions) {
  std::size_t answers = 0;
  for (const auto& entry : fs::directory_iterator(lessons())) {
    if (entry.path().extension() != ".md") continue;
    for (const LessonStep& step : load_lesson(entry.path()).steps) {
      const auto& commands = step.answer.commands;
      if (std::none_of(commands.begin(), commands.end(), [](const LessonCommand& command) {
            return command.text.starts_with("alpha.set") || command.text.starts_with("solvent.set");
          })) {
        continue;
      }
      ++answers;
      EXPECT_EQ(live_fact(step.shown), "") << entry.path().filename() << ", line " << step.line;
    }
  }
  EXPECT_GE(answers, 4u);
}

// Counts the visible characters. A fact counts as many as its name has.
std::size_t characters(const LessonPart& part) {
  std::size_t sum = 0;
  for (const LessonParagraph& paragraph : part.text) {
    for (const LessonSpan& span : lesson_spans(paragraph.text)) {
      sum += static_cast<std::size_t>(std::count_if(span.text.begin(), span.text.end(),
                                                    [](char c) { return (c & 0xc0) != 0x80; }));
    }
  }
  return sum;
}

// At presenter size, the column in a window of 1280 x 800 pixels has 19 lines of about 40
// characters. Each paragraph loses half a line and a gap, so four paragraphs have room for 600
// characters.
TEST(LessonTexts, FitIntoTheirColumn) {
  constexpr std::size_t kMost = 600;
  std::size_t lessons_read = 0;
  for (const auto& entry : fs::directory_iterator(lessons())) {
    if (entry.path().extension() != ".md") continue;
    ++lessons_read;
    for (const LessonStep& step : load_lesson(entry.path()).steps) {
      EXPECT_LE(characters(step.shown) + characters(step.answer), kMost)
          << entry.path().filename() << ", line " << step.line << ": " << step.title;
    }
  }
  EXPECT_EQ(lessons_read, 12u);
}

}  // namespace
}  // namespace alphascope
