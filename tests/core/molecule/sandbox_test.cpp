// SPDX-License-Identifier: GPL-3.0-or-later
// Tests balls set by hand: bounds, planes, and absurd numbers. Complexes stay exact through
// thousands of changes, most of them with ties.
#include "core/molecule/sandbox.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "core/complex/compare.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::random_int;

BallSet two_balls(int z) {
  BallSet balls;
  balls.centres = {{0, 0, 0}, {1000, -2500, z}};
  balls.radii = {1500, 1700};
  return balls;
}

TEST(Sandbox, TakesBallsAsTheyAreAndGivesThemBack) {
  const BallSet balls = two_balls(7);
  const Sandbox sandbox = sandbox_of(balls);
  EXPECT_FALSE(sandbox.flat);
  EXPECT_EQ(centre_of(sandbox, 1), (SandboxPlace{1, -2.5, 0.007}));
  EXPECT_EQ(radius_of(sandbox, 1), 1.7);
  Molecule file;
  file.source = "/somewhere/a.xyzr";
  const Molecule molecule = sandbox_molecule(file, sandbox);
  const PreparedBalls prepared = prepare_balls(molecule);
  EXPECT_EQ(prepared.balls->centres, balls.centres);
  EXPECT_EQ(prepared.balls->radii, balls.radii);
  EXPECT_EQ(molecule.source, file.source);
}

TEST(Sandbox, IsFlatWhereAllBallsAreInThePlane) {
  EXPECT_TRUE(sandbox_of(two_balls(0)).flat);
  EXPECT_FALSE(sandbox_of(two_balls(1)).flat);
  EXPECT_FALSE(sandbox_of(BallSet()).flat);
}

TEST(Sandbox, FlatStaysFlat) {
  Sandbox sandbox = sandbox_of(two_balls(400));
  flatten(sandbox);
  EXPECT_EQ(sandbox.balls[1].centre, (LatticePoint{1000, -2500, 0}));
  move_ball(sandbox, 0, {1, 2, 3});
  EXPECT_EQ(sandbox.balls[0].centre, (LatticePoint{1000, 2000, 0}));
  add_ball(sandbox, {0.0004, 0, -9}, 1);
  EXPECT_EQ(sandbox.balls[2].centre, (LatticePoint{0, 0, 0}));
}

TEST(Sandbox, KeepsAbsurdNumbersWithinItsBounds) {
  Sandbox sandbox;
  const double infinite = std::numeric_limits<double>::infinity();
  add_ball(sandbox, {1e300, -infinite, 0}, -5);
  EXPECT_EQ(centre_of(sandbox, 0), (SandboxPlace{1000, -1000, 0}));
  EXPECT_EQ(sandbox.balls[0].radius, 1);
  resize_ball(sandbox, 0, infinite);
  EXPECT_EQ(radius_of(sandbox, 0), 50);
  EXPECT_THROW(move_ball(sandbox, 0, {std::nan(""), 0, 0}), std::invalid_argument);
  EXPECT_THROW(resize_ball(sandbox, 0, std::nan("")), std::invalid_argument);
  EXPECT_EQ(centre_of(sandbox, 0), (SandboxPlace{1000, -1000, 0}));
  EXPECT_THROW(move_ball(sandbox, 1, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(remove_ball(sandbox, 1), std::invalid_argument);
}

// The finest lattice ends below 1,000 Å.
TEST(Sandbox, EndsWithItsLattice) {
  Sandbox sandbox;
  sandbox.lattice.digits = kMaxLatticeDigits;
  add_ball(sandbox, {1000, -1000, 0}, 50);
  EXPECT_EQ(sandbox.balls[0].centre.x, kMaxLatticeCoordinate);
  EXPECT_EQ(sandbox.balls[0].centre.y, -kMaxLatticeCoordinate);
  EXPECT_EQ(sandbox.balls[0].radius, 50000000);
  EXPECT_LE(sandbox.balls[0].radius, kMaxLatticeRadius);
}

TEST(Sandbox, HasRoomForSoManyBalls) {
  Sandbox sandbox;
  for (std::size_t i = 0; i < kMostSandboxBalls; ++i) add_ball(sandbox, {0, 0, 0}, 1);
  EXPECT_THROW(add_ball(sandbox, {0, 0, 0}, 1), std::invalid_argument);
  EXPECT_EQ(sandbox.balls.size(), kMostSandboxBalls);
  EXPECT_EQ(why_no_sandbox(kMostSandboxBalls), "");
  EXPECT_NE(why_no_sandbox(kMostSandboxBalls + 1), "");
}

TEST(Sandbox, MayBeEmpty) {
  Sandbox sandbox = sandbox_of(two_balls(0));
  remove_ball(sandbox, 0);
  remove_ball(sandbox, 0);
  const PreparedBalls prepared = prepare_balls(sandbox_molecule({}, sandbox));
  EXPECT_EQ(prepared.balls->size(), 0u);
}

// Makes one change after another, as a user does, on a coarse grid, where most sets have ties.
void walk(Sandbox sandbox, int moves, std::uint64_t seed) {
  Random random(seed);
  const auto place = [&] {
    const auto half = [&] { return random_int(random, -6, 6) * 0.5; };
    const double x = half(), y = half();
    return SandboxPlace{x, y, half()};
  };
  int with_triangles = 0;
  for (int move = 0; move < moves; ++move) {
    const int kind = random_int(random, 0, 9);
    const auto any = [&] {
      return static_cast<std::size_t>(
          random_int(random, 0, static_cast<int>(sandbox.balls.size()) - 1));
    };
    if (sandbox.balls.empty() || (kind == 0 && sandbox.balls.size() < 14)) {
      add_ball(sandbox, place(), random_int(random, 1, 4) * 0.5);
    } else if (kind == 1) {
      remove_ball(sandbox, any());
    } else if (kind < 5) {
      resize_ball(sandbox, any(), random_int(random, 1, 4) * 0.5);
    } else {
      move_ball(sandbox, any(), place());
    }
    const auto balls = prepare_balls(sandbox_molecule({}, sandbox)).balls;
    const double alpha =
        balls->lattice.alpha_on_lattice(random_int(random, -2, 12) * 0.25).nearest();
    const AlphaComplex ours = make_cpu_engine(balls, {1})->compute({alpha}, {});
    const AlphaComplex cgal = make_cgal_engine(balls, {1})->compute({alpha}, {});
    ASSERT_TRUE(compare(ours, cgal).identical()) << "move " << move << " of seed " << seed;
    ASSERT_EQ(ours.hash, cgal.hash);
    with_triangles += ours.triangles.size() > 0;
  }
  EXPECT_GT(with_triangles, moves / 10);
}

TEST(Sandbox, StaysEqualToCgalThroughTenThousandMovesInThePlane) {
  Sandbox sandbox;
  sandbox.flat = true;
  walk(sandbox, testing::unless_sanitized(10000, 1000), 61);
}

TEST(Sandbox, StaysEqualToCgalThroughTenThousandMovesInSpace) {
  walk({}, testing::unless_sanitized(10000, 1000), 62);
}

}  // namespace
}  // namespace alphascope
