// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the views between two views of a camera that glides.
#include "ui/scene/view_between.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

void expect_near(const Vector& a, const Vector& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-9) << k;
}

const Viewpoint kFront{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1};

TEST(ViewBetween, HasTheViewsThemselvesAtItsEnds) {
  const Viewpoint to{{3, 4, 5}, {1, 0.1, 0}, {0, 0.9, 0.1}, 2};
  EXPECT_EQ(view_between(kFront, to, 0), kFront);
  EXPECT_EQ(view_between(kFront, to, 1), to);
}

TEST(ViewBetween, TurnsAboutOneAxisAtAConstantDistance) {
  const Viewpoint side{{10, 0, 0}, {0, 0, 0}, {0, 1, 0}, 1};
  for (const double share : {0.25, 0.5, 0.75}) {
    const Viewpoint between = view_between(kFront, side, share);
    const double angle = share * M_PI / 2;
    expect_near(between.position, {10 * std::sin(angle), 0, 10 * std::cos(angle)});
    expect_near(between.up, {0, 1, 0});
  }
}

// Views from opposite sides do not tell an axis: the camera must not pass through the middle.
TEST(ViewBetween, GoesAroundBetweenOppositeViews) {
  for (const Viewpoint& back : {Viewpoint{{0, 0, -10}, {0, 0, 0}, {0, 1, 0}, 1},
                                Viewpoint{{0, 0, -10}, {0, 0, 0}, {0, -1, 0}, 1},
                                Viewpoint{{0, 0, -10}, {0, 0, 0}, {1, 0, 0}, 1}}) {
    const Viewpoint between = view_between(kFront, back, 0.5);
    EXPECT_NEAR(distance(between.position, between.focal_point), 10, 1e-9);
    EXPECT_NEAR(between.position[2], 0, 1e-9);
    const Viewpoint nearly = view_between(kFront, back, 1 - 1e-9);
    EXPECT_LT(distance(nearly.position, back.position), 1e-6);
    EXPECT_LT(distance(nearly.up, back.up), 1e-6);
  }
}

TEST(ViewBetween, ZoomsByEqualFactorsAndMovesTheMiddleOnALine) {
  const Viewpoint far{{8, 0, 1000}, {8, 0, 0}, {0, 1, 0}, 3};
  const Viewpoint between = view_between(kFront, far, 0.5);
  expect_near(between.focal_point, {4, 0, 0});
  expect_near(between.position, {4, 0, 100});
  EXPECT_NEAR(between.least_aspect, 2, 1e-12);
}

}  // namespace
}  // namespace alphascope
