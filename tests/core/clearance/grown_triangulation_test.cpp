// SPDX-License-Identifier: GPL-3.0-or-later
// Tests grown balls and the helping balls around them.
#include "core/clearance/grown_triangulation.hpp"

#include <gtest/gtest.h>

#include "core/geometry/alpha.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

TEST(GrownTriangulation, HelpingBallsAreFarAwayOnAnyLattice) {
  for (const int digits : {2, 3, 4}) {
    BallSet balls;
    balls.lattice.digits = digits;
    testing::add_ball(balls, 0, 0, 0, 100);
    testing::add_ball(balls, 300, 0, 0, 100);
    testing::add_ball(balls, 0, 400, 0, 100);
    PassageEnds ends;
    ends.from = {100, 100, 0};
    const auto scene = GrownTriangulations(balls, ends).at(5, {});
    EXPECT_EQ(scene->balls.lattice.digits, digits);
    ASSERT_EQ(scene->original.size(), 3u);
    for (int n = 0; n < 3; ++n) EXPECT_EQ(scene->balls.radii[n], 105);
    ASSERT_EQ(scene->from, 3u + 12);
    // Three diagonals of the box plus 20 Å, from its middle.
    const double far_away = 3 * 500 + 20 * balls.lattice.units_per_angstrom();
    for (std::size_t n = 3; n < 15; ++n) {
      EXPECT_NEAR(length(real_point(scene->balls.centres[n]) - RealPoint{150, 200, 0}), far_away, 1)
          << digits;
      EXPECT_EQ(scene->balls.radii[n], 1);
    }
  }
}

}  // namespace
}  // namespace alphascope
