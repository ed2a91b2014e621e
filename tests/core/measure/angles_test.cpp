// SPDX-License-Identifier: GPL-3.0-or-later
// Tests distances and angles: by hand, turned and moved, at the limits of the lattice, and where
// there is none.
#include "core/measure/angles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {
namespace {

constexpr std::int32_t kMost = kMaxLatticeCoordinate;

TEST(AnglesOfPoints, ByHand) {
  EXPECT_EQ(distance_on_lattice({1, 2, 3}, {4, 6, 15}), 13);
  EXPECT_EQ(distance_on_lattice({5, -6, 7}, {5, -6, 7}), 0);
  EXPECT_DOUBLE_EQ(*angle_degrees({1, 0, 0}, {0, 0, 0}, {0, 5, 0}), 90);
  EXPECT_DOUBLE_EQ(*angle_degrees({1, 1, 0}, {0, 0, 0}, {7, 0, 0}), 45);
  EXPECT_DOUBLE_EQ(*angle_degrees({1, 0, 0}, {0, 0, 0}, {-3, 0, 0}), 180);
  EXPECT_EQ(*angle_degrees({2, 4, 6}, {0, 0, 0}, {1, 2, 3}), 0);
  // In methane: the angle at the centre of a tetrahedron between two corners.
  EXPECT_NEAR(*angle_degrees({1, 1, 1}, {0, 0, 0}, {1, -1, -1}), 109.47122063449069, 1e-12);
}

// The view is along the line from (0, 0, 0) to (0, 0, 9), with x to the right and so y downwards.
TEST(AnglesOfPoints, DihedralsAreClockwiseSeenFromTheSecondAtom) {
  const LatticePoint a{4, 0, -1}, b{0, 0, 0}, c{0, 0, 9};
  EXPECT_DOUBLE_EQ(*dihedral_degrees(a, b, c, {0, 3, 12}), 90);
  EXPECT_DOUBLE_EQ(*dihedral_degrees(a, b, c, {0, -3, 12}), -90);
  EXPECT_DOUBLE_EQ(*dihedral_degrees(a, b, c, {2, 2, 3}), 45);
  EXPECT_EQ(*dihedral_degrees(a, b, c, {5, 0, 3}), 0);
  EXPECT_EQ(*dihedral_degrees(a, b, c, {-5, 0, 3}), 180) << "trans, never -180";
  // In reverse order the turn is the same.
  EXPECT_DOUBLE_EQ(*dihedral_degrees({0, 3, 12}, c, b, a), 90);
}

// 10^-9 degrees from 180, on both sides.
TEST(AnglesOfPoints, AlmostTransKeepsItsSide) {
  const LatticePoint a{kMost, 0, 0}, b{0, 0, 0}, c{0, 0, kMost};
  const double above = *dihedral_degrees(a, b, c, {-kMost, 1, kMost}),
               below = *dihedral_degrees(a, b, c, {-kMost, -1, kMost});
  EXPECT_GT(above, 179.9999998);
  EXPECT_LT(above, 180);
  EXPECT_EQ(below, -above);
}

TEST(AnglesOfPoints, NoneWherePointsCoincideOrLieOnALine) {
  const LatticePoint p{3, 4, 5}, q{9, 1, 2}, r{1, 1, 8};
  EXPECT_FALSE(angle_degrees(p, p, q));
  EXPECT_FALSE(angle_degrees(q, p, p));
  EXPECT_EQ(*angle_degrees(p, q, p), 0);
  EXPECT_FALSE(dihedral_degrees(p, q, q, r));
  EXPECT_FALSE(dihedral_degrees(p, p, q, r));
  EXPECT_FALSE(dihedral_degrees(p, q, r, r));
  EXPECT_FALSE(dihedral_degrees({0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {5, 5, 5}));
  EXPECT_FALSE(dihedral_degrees({5, 5, 5}, {0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
  // One unit of 10^9 beside the line an angle exists.
  EXPECT_FALSE(dihedral_degrees({-kMost, -kMost, 0}, {0, 0, 0}, {kMost, kMost, 0}, {0, 0, 1}));
  EXPECT_TRUE(dihedral_degrees({-kMost, 1 - kMost, 0}, {0, 0, 0}, {kMost, kMost, 0}, {0, 0, 1}));
}

using Matrix = std::array<RealPoint, 3>;  // rows

Matrix random_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const RealPoint axis = unit_vector({normal(random), normal(random), normal(random)});
  RealPoint first, second;
  normals_of(axis, first, second);
  const double turn = std::uniform_real_distribution<double>(0, 6.283)(random);
  return {std::cos(turn) * first + std::sin(turn) * second,
          std::cos(turn) * second - std::sin(turn) * first, axis};
}

LatticePoint placed(const Matrix& turn, const RealPoint& p, const RealPoint& shift) {
  const RealPoint turned{dot(turn[0], p), dot(turn[1], p), dot(turn[2], p)};
  return nearest_lattice_point(turned + shift);
}

// Bonds of about 1.5 Å on a lattice of 10^-6 Å, at random places and orientations. The angles come
// back to within the rounding on the lattice.
TEST(AnglesOfPoints, TurnedAndMovedTheyStay) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr double kBond = 1.5e6, kDegree = 3.14159265358979323846 / 180;
  for (int round = 0; round < 2000; ++round) {
    const double angle = between(10, 170), dihedral = between(-180, 180);
    const Matrix turn = random_turn(random);
    const RealPoint shift{between(-4e8, 4e8), between(-4e8, 4e8), between(-4e8, 4e8)};
    // The line of the dihedral angle is z. A clockwise turn for a view along it is a positive turn
    // from x to y.
    const double s = kBond * std::sin(angle * kDegree), h = kBond * std::cos(angle * kDegree);
    const LatticePoint a = placed(turn, {s, 0, h}, shift), b = placed(turn, {0, 0, 0}, shift),
                       c = placed(turn, {0, 0, kBond}, shift),
                       d = placed(turn,
                                  {s * std::cos(dihedral * kDegree),
                                   s * std::sin(dihedral * kDegree), kBond - h},
                                  shift);
    EXPECT_NEAR(distance_on_lattice(b, c), kBond, 2);
    EXPECT_NEAR(*angle_degrees(a, b, c), angle, 3e-4);
    EXPECT_NEAR(*dihedral_degrees(a, b, c, d), dihedral, 2e-3);
    EXPECT_EQ(*dihedral_degrees(a, b, c, d), *dihedral_degrees(d, c, b, a));
  }
}

TEST(AnglesOfPoints, TheLargestCoordinatesDoNotOverflow) {
  const LatticePoint a{-kMost, -kMost, -kMost}, b{kMost, kMost, kMost}, c{-kMost, kMost, kMost},
      d{kMost, -kMost, kMost};
  EXPECT_DOUBLE_EQ(distance_on_lattice(a, b), 2.0 * kMost * std::sqrt(3.0));
  EXPECT_NEAR(*angle_degrees(a, b, c), 54.735610317245346, 1e-12);
  // Two diagonals of a cube's faces and one of the cube itself.
  EXPECT_NEAR(std::fabs(*dihedral_degrees(c, a, b, d)), 120, 1e-12);
}

}  // namespace
}  // namespace alphascope
