// Numbers that stand in the lessons' texts and are no facts of the complex on screen: they are what
// the program computes.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "core/explain/explanation.hpp"
#include "core/io/read_molecule.hpp"
#include "core/molecule/prepare_balls.hpp"

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

// "0.000000133", of the size of a number.
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
  ASSERT_EQ(apart.absence, Absence::none);
  ASSERT_EQ(apart.nearest.at(0).sign, 1);
  expect_said(text, "0.00485 Å²");
  EXPECT_EQ(decimals(apart.nearest[0].margin_angstrom2, 5), "0.00485");

  const Explanation tie = explain(*balls_of("near_tie.xyzr"), four, std::nullopt);
  ASSERT_NE(tie.absence, Absence::none);
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

// The corners of the cell of the middle ball: 3.637 Å from it.
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

}  // namespace
}  // namespace alphascope
