// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the sentences of explanations: each number has a unit, and each kind of answer its text.
#include "core/document/explain/explanation_text.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

std::string text_of(const BallSet& balls, const std::vector<BallIndex>& simplex,
                    std::optional<double> alpha) {
  std::string text;
  const auto name = [](BallIndex ball) { return "N" + std::to_string(ball); };
  for (const ExplanationLine& line : explanation_lines(explain(balls, simplex, alpha), name)) {
    text += line.text + "\n";
  }
  return text;
}
void expect_said(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }
}

BallSet unit_balls() {
  BallSet balls;
  balls.lattice.digits = 0;
  return balls;
}

TEST(ExplanationText, OfAnAttachedEdge) {
  BallSet balls = unit_balls();
  testing::add_ball(balls, -10, 0, 0, 1);
  testing::add_ball(balls, 10, 0, 0, 1);
  testing::add_ball(balls, 0, 4, 0, 1);  // in the sphere of the edge, radius² 99
  testing::add_ball(balls, 0, 0, 30, 1);
  // The circle through the three: its centre is (0, -10.5, 0), its radius 14.5.
  expect_said(text_of(balls, {0, 1}, 200.0),
              {"edge of balls 0 (N0) and 1 (N1)", "ρ = 99 Å²", "√ρ = 9.94987 Å",
               "ball 2 (N2) has the power distance 15 Å²", "the margin -84 Å²",
               "inside the orthosphere", "it is attached",
               "The first is the triangle of balls 0 (N0), 1 (N1) and 2 (N2). The ρ of that is its "
               "alpha value, 209.25 Å²",
               "not in the alpha complex at alpha = 200 Å²", "It is never singular"});
  expect_said(text_of(balls, {0, 1}, 300.0),
              {"It is in the alpha complex at alpha = 300 Å²", "It never becomes interior"});
}

TEST(ExplanationText, OfWhatIsAbsent) {
  BallSet balls = unit_balls();
  testing::add_ball(balls, 0, 0, 0, 5);
  testing::add_ball(balls, 1, 0, 0, 1);  // hidden by the first
  testing::add_ball(balls, 20, 0, 0, 1);
  testing::add_ball(balls, 0, 20, 0, 1);
  testing::add_ball(balls, 20, 20, 0, 2);
  testing::add_ball(balls, 0, 0, 20, 1);
  expect_said(text_of(balls, {1}, {}), {"in no alpha complex", "Its ball 1 (N1) is hidden",
                                        "ball 0 (N0) has less or the same"});
  expect_said(text_of(balls, {0, 2, 3, 4}, {}),
              {"Its four centres lie in one plane", "There is none: its centres lie in one plane"});
  // The diagonal of a square, with a larger ball at a corner beside it.
  expect_said(text_of(balls, {2, 3}, {}), {"in no alpha complex", "ball 0 (N0) has less"});
  expect_said(text_of(balls, {2, 3, 5}, {}), {"The edge of balls 2 (N2) and 3 (N3) is not in it"});
}

TEST(ExplanationText, OfATie) {
  BallSet balls = unit_balls();
  for (const int x : {0, 2}) {
    for (const int y : {0, 2}) testing::add_ball(balls, x, y, 0, 1);
  }
  expect_said(text_of(balls, {0, 3}, {}),
              {"a tie, with the margin 0 Å²", "integers: 0 Å², exactly compared. It is a tie.",
               "the perturbation decides"});
}

// In the plane a triangle has the role of a tetrahedron.
TEST(ExplanationText, SpeaksOfThePlaneWhereAllCentresAreInOne) {
  BallSet balls = unit_balls();
  for (const int x : {0, 2}) {
    for (const int y : {0, 2}) testing::add_ball(balls, x, y, 5, 1);
  }
  // Sides have ρ = 0, the diagonal and both triangles ρ = 1.
  using Balls = std::vector<BallIndex>;
  const bool first = explain(balls, Balls{0, 3}, {}).absence == AbsenceReason::none;
  expect_said(text_of(balls, first ? Balls{0, 3} : Balls{1, 2}, 1.0),
              {"All centres are in one plane", "It is interior: everything around it is filled",
               "when the last triangle around it appears"});
  expect_said(text_of(balls, first ? Balls{0, 1, 3} : Balls{0, 1, 2}, 1.0),
              {"It is interior", "Nothing in the plane is larger: this triangle is interior",
               "meets it in the orthocircle, which has the same centre and the same ρ"});
  expect_said(text_of(balls, {0, 1}, 1.0),
              {"It is regular", "until it becomes regular at alpha = 1 Å²", "on the hull"});
}

TEST(ExplanationText, SpeaksOfTheLineAndThePoint) {
  BallSet balls = unit_balls();
  for (const int x : {0, 4, 8}) testing::add_ball(balls, x, x, 0, 1);
  expect_said(text_of(balls, {1}, 100.0),
              {"All centres are on one line", "It is interior", "when the last edge around it"});
  expect_said(text_of(balls, {0}, 100.0), {"It is regular", "on the hull of all balls"});
  expect_said(text_of(balls, {0, 1}, 100.0), {"Nothing on the line is larger: this edge"});
  BallSet alone = unit_balls();
  testing::add_ball(alone, 1, 2, 3, 1);
  expect_said(text_of(alone, {0}, 0.0), {"at one point", "Nothing at the point is larger"});
}

}  // namespace
}  // namespace alphascope
