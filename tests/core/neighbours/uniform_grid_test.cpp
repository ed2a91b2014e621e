// SPDX-License-Identifier: GPL-3.0-or-later
// Tests cells of balls: two balls that may meet are always in the same cell or in neighbouring
// ones.
#include "core/neighbours/uniform_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/grown_balls.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

// For each ball the balls in its cell and the cells around it.
std::vector<std::set<BallIndex>> around(const BallSet& balls, const UniformGrid& grid) {
  std::vector<std::set<BallIndex>> result(balls.size());
  for (std::size_t s = 0; s < grid.size(); ++s) {
    const BallIndex i = grid.ball[s];
    grid.for_rows_around(grid.cell_at(balls.centres[i]),
                         [&](std::uint32_t begin, std::uint32_t end) {
                           for (std::uint32_t t = begin; t < end; ++t) {
                             EXPECT_TRUE(result[i].insert(grid.ball[t]).second) << "twice";
                           }
                         });
  }
  return result;
}

bool may_meet(const BallSet& balls, BallIndex i, BallIndex j, const LatticeAlpha& alpha) {
  const LatticePoint &p = balls.centres[i], &q = balls.centres[j];
  const double a = alpha.plus(balls.weight(i)), b = alpha.plus(balls.weight(j));
  return a >= 0 && b >= 0 &&
         grown_balls_may_meet(q.x - p.x, q.y - p.y, q.z - p.z, grown_reach(a), grown_reach(b));
}

// Two touching balls. With cells as wide as both together, the first would end a unit before its
// cell's end.
TEST(UniformGrid, BallsThatTouchAreInNeighbouringCells) {
  for (const int axis : {0, 1, 2}) {
    BallSet balls;
    for (const auto& [at, radius] : {std::pair(0, 1), {199'997, 100'000}, {399'997, 100'000}}) {
      testing::add_ball(balls, axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0, radius);
    }
    const UniformGrid grid = make_uniform_grid(balls, balls.lattice.alpha_on_lattice(0), {});
    EXPECT_TRUE(around(balls, grid)[1].contains(2)) << axis;
    EXPECT_TRUE(around(balls, grid)[2].contains(1)) << axis;
  }
}

TEST(UniformGrid, AllThatMayMeetAreFound) {
  Random random(31);
  for (const testing::NamedBalls& set : testing::large_hard_sets(random, 150)) {
    SCOPED_TRACE(set.name);
    const BallSet& balls = set.balls;
    for (const double units : {-1.0, 0.0, 2.0}) {
      const LatticeAlpha alpha = balls.lattice.alpha_on_lattice(units * set.alpha_unit());
      const UniformGrid grid = make_uniform_grid(balls, alpha, {});
      const auto near = around(balls, grid);
      for (BallIndex i = 0; i < balls.size(); ++i) {
        for (BallIndex j = 0; j < balls.size(); ++j) {
          if (may_meet(balls, i, j, alpha)) {
            ASSERT_TRUE(near[i].contains(j)) << i << ' ' << j;
          }
        }
      }
    }
  }
}

TEST(UniformGrid, CostIsThePairsThatAreLookedAt) {
  Random random(32);
  const BallSet balls = testing::random_balls(random, 400, 3000, 50, 150);
  const UniformGrid grid = make_uniform_grid(balls, balls.lattice.alpha_on_lattice(0), {});
  ASSERT_GT(grid.nx * grid.ny * grid.nz, 100);
  std::size_t pairs = 0;
  for (const auto& near : around(balls, grid)) pairs += near.size();
  EXPECT_EQ(grid.search_cost(), static_cast<double>(pairs));
  std::vector<bool> hidden(balls.size(), false);
  hidden[7] = true;
  const UniformGrid rest = make_uniform_grid(balls, balls.lattice.alpha_on_lattice(0), hidden);
  EXPECT_EQ(rest.size(), balls.size() - 1);
  EXPECT_EQ(std::count(rest.ball.begin(), rest.ball.end(), BallIndex{7}), 0);
}

}  // namespace
}  // namespace alphascope
