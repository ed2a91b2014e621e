// SPDX-License-Identifier: GPL-3.0-or-later
// Tests from numbers alone what a view shows.
#include "ui/scene/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

BallGeometry two_balls() {  // 20 Å apart
  BallGeometry g;
  g.centres = {{-10, 0, 0}, {10, 0, 0}};
  g.radii = {2, 2};
  g.bounds = {-12, 12, -2, 2, -2, 2};
  return g;
}

ViewFrustum from(double x, double y, double z) {  // looking along -z
  ViewFrustum s;
  s.position = {x, y, z};
  s.tangent_right = s.tangent_up = 0.2;
  return s;
}

const std::vector<float> kRadii{2, 2}, kNotDrawn;

TEST(ViewProblem, NoneWhereABallIsInView) {
  EXPECT_EQ(view_problem(two_balls(), kRadii, from(0, 0, 80), false), ViewProblem::none);
  EXPECT_EQ(view_problem(two_balls(), kRadii, from(10, 0, 5), false), ViewProblem::none);
}

TEST(ViewProblem, InsideABall) {
  EXPECT_EQ(view_problem(two_balls(), kRadii, from(10, 0, 1.9), false), ViewProblem::inside_a_ball);
  EXPECT_EQ(view_problem(two_balls(), kNotDrawn, from(10, 0, 1.9), true), ViewProblem::none);
  EXPECT_EQ(view_problem({}, {}, from(0, 0, 0), false), ViewProblem::none);
}

// The last ball counts even if earlier balls are well in view.
TEST(ViewProblem, InsideTheLastBallOfMany) {
  BallGeometry g;
  for (int i = 0; i < 100; ++i) g.centres.push_back({0, 0, -10.0f - static_cast<float>(i)});
  g.centres.push_back({0, 0, 5});
  g.radii.assign(101, 1);
  g.bounds = {-1, 1, -1, 1, -110, 6};
  std::vector<float> grown(101, 1);
  EXPECT_EQ(view_problem(g, grown, from(0, 0, 7), true), ViewProblem::none);
  grown.back() = 3;  // larger than given, and around the camera
  EXPECT_EQ(view_problem(g, grown, from(0, 0, 7), true), ViewProblem::inside_a_ball);
  EXPECT_EQ(view_problem(g, grown, from(0, 0, 9), true), ViewProblem::none);
}

TEST(ViewProblem, NothingInView) {
  for (const auto& s :
       {from(0, 0, -5), from(0, 300, 80), from(0, -300, 80), from(300, 0, 80), from(-300, 0, 80)}) {
    EXPECT_EQ(view_problem(two_balls(), kRadii, s, false), ViewProblem::nothing_in_view);
    EXPECT_EQ(view_problem(two_balls(), kNotDrawn, s, true), ViewProblem::nothing_in_view);
  }
  // An edge between the two balls is in view, if it exists.
  EXPECT_EQ(view_problem(two_balls(), kRadii, from(0, 0, 10), false), ViewProblem::nothing_in_view);
  EXPECT_EQ(view_problem(two_balls(), kRadii, from(0, 0, 10), true), ViewProblem::none);
}

TEST(ViewProblem, EmptyBallsAreNotSeen) {
  EXPECT_EQ(view_problem(two_balls(), {0, 0}, from(0, 0, 80), false), ViewProblem::nothing_in_view);
}

TEST(ViewAngle, GrowsOnlyWhereThePictureIsTooNarrow) {
  const double usual = tangent_up(1, 0);
  EXPECT_DOUBLE_EQ(tangent_up(2, 1.5), usual);
  EXPECT_DOUBLE_EQ(tangent_up(1.5, 1.5), usual);
  // The sides do not move.
  EXPECT_DOUBLE_EQ(tangent_up(0.5, 1.5) * 0.5, usual * 1.5);
}

TEST(FittingDistance, IsOfTheLargerOfGivenAndDrawnRadii) {
  const BallGeometry balls = two_balls();
  const double given = fitting_distance(balls, {}, 1.5);
  const std::vector<float> small(2, 0.1f), grown(2, 20.0f);
  EXPECT_DOUBLE_EQ(fitting_distance(balls, small, 1.5), given);
  // A ball that reaches so far up is seen at the usual angle from this distance on.
  EXPECT_GT(fitting_distance(balls, grown, 1.5), 20 / tangent_up(1.5, 0));
  EXPECT_GT(fitting_distance(balls, grown, 1.5), given);
}

TEST(ViewAngle, LeastAspectIsThatOfWhatIsInThePicture) {
  const BallGeometry balls = two_balls();
  ViewFrustum s = from(0, 0, 100);
  s.tangent_up = tangent_up(2, 0);
  s.tangent_right = 2 * s.tangent_up;
  const double aspect = least_aspect(balls, s, 2);
  EXPECT_NEAR(aspect, 0.12 / s.tangent_up, 0.03 * aspect);  // 12 Å to a side, 100 Å away
  s.position[2] = 20;
  EXPECT_DOUBLE_EQ(least_aspect(balls, s, 2), 2) << "cut off already: what is seen stays";
}

}  // namespace
}  // namespace alphascope
