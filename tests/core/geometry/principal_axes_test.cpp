// The default direction of a pore.
#include "core/geometry/principal_axes.hpp"

#include <gtest/gtest.h>

#include "tests/core/cavity/rings.hpp"

namespace alphascope {
namespace {

TEST(PrincipalAxes, TheMainAxisIsThatOfEqualCopies) {
  BallSet flat = testing::no_balls();
  for (const double z : {-2.0, 0.0, 5.0}) testing::add_ring(flat, 4, 20, z, 1);
  testing::add_ring(flat, 4, 9, 3, 1);
  const MainAxis of_flat = main_axis(flat);
  EXPECT_NEAR(of_flat.axis.z, 1, 1e-6) << "the shortest, but alike around it";
  EXPECT_NEAR(of_flat.middle_angstrom.z, 1.5, 1e-3);
  BallSet tall = testing::no_balls();
  testing::add_tube(tall, -20, 20);
  EXPECT_NEAR(main_axis(tall).axis.z, 1, 1e-6);
}

TEST(PrincipalAxes, WithoutCopiesItIsTheLongest) {
  BallSet balls = testing::no_balls();
  testing::add_ball(balls, -9000, 0, 0, 1000);
  testing::add_ball(balls, 9000, 0, 0, 1000);
  testing::add_ball(balls, 0, 5000, 0, 1000);
  testing::add_ball(balls, 0, -5000, 2000, 1000);
  EXPECT_NEAR(main_axis(balls).axis.x, 1, 1e-6);
  BallSet one = testing::no_balls();
  testing::add_ball(one, 1000, 2000, 3000, 1000);
  EXPECT_EQ(main_axis(one).axis, (RealPoint{0, 0, 1}));
  EXPECT_EQ(main_axis(one).middle_angstrom, (RealPoint{1, 2, 3}));
}

}  // namespace
}  // namespace alphascope
