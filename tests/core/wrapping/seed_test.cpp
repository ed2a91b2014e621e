// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a seed is a tetrahedron of CGAL's triangulation, also among hidden and coincident
// balls, in lattices and at the bounds of coordinates.
#include "core/wrapping/seed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/triangulation/cgal_triangulation.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

// Returns whether there is a seed.
bool expect_seed(const BallSet& balls) {
  const Triangulation whole = make_cgal_triangulation(balls, 1);
  const auto seed = seed_tetrahedron(balls, {});
  EXPECT_EQ(seed.has_value(), whole.dimension == 3);
  if (!seed) return false;
  EXPECT_TRUE(std::binary_search(whole.tetrahedra.begin(), whole.tetrahedra.end(), *seed));
  return true;
}

TEST(Seed, IsATetrahedronOfTheTriangulation) {
  Random random(91);
  int seeds = 0, flat = 0;
  std::vector<NamedBalls> sets = testing::small_hard_sets(random, 40);
  for (NamedBalls& set : testing::large_hard_sets(random)) sets.push_back(std::move(set));
  for (const NamedBalls& set : sets) {
    SCOPED_TRACE(set.name);
    ++(expect_seed(set.balls) ? seeds : flat);
    if (HasFailure()) return;
  }
  EXPECT_GT(seeds, 50);
  EXPECT_GT(flat, 10);
}

// Nearly all balls are hidden, and many have the centre of the largest.
TEST(Seed, IsFoundAmongHiddenBalls) {
  Random random(92);
  for (int n = 0; n < 20; ++n) {
    BallSet balls = testing::random_balls(random, 600, 300, 1, 40);
    for (int k = 0; k < 8; ++k) testing::add_ball(balls, 40 * k, 300 - 37 * k, 11 * k * k, 280 + k);
    for (int k = 1; k < 6; ++k) {
      const LatticePoint& p = balls.centres.back();
      testing::add_ball(balls, p.x, p.y, p.z, 280 + k);
    }
    EXPECT_TRUE(expect_seed(balls));
  }
}

TEST(Seed, IsCancelled) {
  Random random(93);
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(seed_tetrahedron(testing::random_balls(random, 100, 400, 20, 200), cancel),
               Cancelled);
}

}  // namespace
}  // namespace alphascope
