// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the default direction of a pore.
#include "core/geometry/principal_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/geometry/alpha.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

// A V = V D, and the columns of V are orthonormal.
TEST(Diagonalise, FindsEigenvaluesAndVectors) {
  testing::Random random(81);
  std::uniform_real_distribution<double> number(-3, 3);
  for (int round = 0; round < 100; ++round) {
    Matrix3 a{};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = j; k < 3; ++k) a[j][k] = a[k][j] = number(random);
    }
    Matrix3 diagonal = a, vectors{};
    diagonalise(diagonal, vectors);
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        double of_a = 0, of_vectors = 0;
        for (std::size_t n = 0; n < 3; ++n) {
          of_a += a[j][n] * vectors[n][k];
          of_vectors += vectors[n][j] * vectors[n][k];
        }
        EXPECT_NEAR(of_a, vectors[j][k] * diagonal[k][k], 1e-12);
        EXPECT_NEAR(of_vectors, j == k, 1e-12);
        if (j != k) {
          EXPECT_NEAR(diagonal[j][k], 0, 1e-12);
        }
      }
    }
  }
  Matrix3 known{{{2, 1, 0}, {1, 2, 0}, {0, 0, 5}}}, vectors{};
  diagonalise(known, vectors);
  std::array<double, 3> values{known[0][0], known[1][1], known[2][2]};
  std::sort(values.begin(), values.end());
  EXPECT_NEAR(values[0], 1, 1e-12);
  EXPECT_NEAR(values[1], 3, 1e-12);
  EXPECT_NEAR(values[2], 5, 1e-12);
}

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

TEST(PrincipalAxes, TheFirstOfComponentsAsLongIsPositive) {
  BallSet balls = testing::no_balls();
  testing::add_ball(balls, -5000, 5000, 0, 1000);
  testing::add_ball(balls, 5000, -5000, 0, 1000);
  const MainAxis found = main_axis(balls);
  EXPECT_NEAR(found.axis.x, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(found.axis.y, -std::sqrt(0.5), 1e-12);
}

TEST(PrincipalAxes, APoreLeadsAlongTheMainOneOrAnyOfThree) {
  BallSet tall = testing::no_balls();
  testing::add_tube(tall, -20, 20);
  ASSERT_EQ(pore_axes(tall).size(), 1u);
  EXPECT_EQ(pore_axes(tall)[0], main_axis(tall).axis);
  BallSet box = testing::no_balls();
  for (const int x : {-9000, 9000}) {
    for (const int y : {-6000, 6000}) {
      for (const int z : {-3000, 3000}) testing::add_ball(box, x, y, z, 1000);
    }
  }
  const std::vector<RealPoint> axes = pore_axes(box);
  ASSERT_EQ(axes.size(), 3u);
  EXPECT_NEAR(axes[0].x, 1, 1e-6);
  EXPECT_NEAR(axes[1].y, 1, 1e-6);
  EXPECT_NEAR(axes[2].z, 1, 1e-6);
}

}  // namespace
}  // namespace alphascope
