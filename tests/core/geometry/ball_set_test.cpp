// SPDX-License-Identifier: GPL-3.0-or-later
// Tests solvent radii on the lattice: exact where the bounds leave room.
#include "core/geometry/ball_set.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace alphascope {
namespace {

BallSet balls(int digits, std::int32_t x) {
  return {Lattice{digits}, {{0, 0, 0}, {x, -x, 7}}, {1700, 1500}};
}

TEST(Lattice, KnowsTheDecimalsThatItHolds) {
  for (const double held : {0.0, 1.4, 1.1, 0.001, 0.3, 2.675, 99.999, 1.005}) {
    EXPECT_TRUE(Lattice{3}.holds(held)) << held;
  }
  for (const double not_held : {0.0004, 1.0005, 1e-9, 1.4000001}) {
    EXPECT_FALSE(Lattice{3}.holds(not_held)) << not_held;
  }
  EXPECT_FALSE(Lattice{0}.holds(1.4));
  EXPECT_TRUE(Lattice{6}.holds(1.234567));
}

TEST(WithSolvent, KeepsTheLatticeThatHoldsIt) {
  const BallSet before = balls(3, 1000);
  const BallSet grown = with_solvent(before, 1.4);
  EXPECT_EQ(grown.lattice.digits, 3);
  EXPECT_EQ(grown.radii, (std::vector<std::int32_t>{3100, 2900}));
  EXPECT_EQ(grown.centres, before.centres);
}

TEST(WithSolvent, TakesTheCoarsestLatticeThatHoldsIt) {
  const BallSet four = with_solvent(balls(3, 1000), 0.0004);
  EXPECT_EQ(four.lattice.digits, 4);
  EXPECT_EQ(four.radii, (std::vector<std::int32_t>{17004, 15004}));
  EXPECT_EQ(four.centres[1], (LatticePoint{10000, -10000, 70}));
  const BallSet one = with_solvent(balls(0, 1000), 1.4);
  EXPECT_EQ(one.lattice.digits, 1);
  EXPECT_EQ(one.radii[0], 17014);
}

TEST(WithSolvent, RoundsToTheFinestWhereTheBoundsLeaveNoRoom) {
  const BallSet far = with_solvent(balls(0, kMaxLatticeCoordinate), 1.4);
  EXPECT_EQ(far.lattice.digits, 0);
  EXPECT_EQ(far.radii[0], 1701);
  EXPECT_EQ(solvent_on_lattice(far.lattice, 1.4), 1);
  EXPECT_EQ(with_solvent(balls(3, 50'000'000), 0.00044).lattice.digits, 4);
  // Radii are bounded as well.
  BallSet wide = balls(3, 1000);
  wide.radii[0] = kMaxLatticeRadius - 5;
  EXPECT_EQ(with_solvent(wide, 0.0004).lattice.digits, 3);
  EXPECT_EQ(with_solvent(wide, 0.005).radii[0], kMaxLatticeRadius);
  EXPECT_THROW(with_solvent(wide, 0.006), std::invalid_argument);
  EXPECT_THROW(with_solvent(wide, -0.0001), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
