// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the cells of the tuple engine.
#include "core/tuples/tuple_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory_resource>

#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

// A box from (0, 0, 0) to (12345, 6789, 99) units, with many balls inside.
BallSet box_of_balls() {
  testing::Random random(91);
  BallSet balls;
  testing::add_ball(balls, 0, 0, 0, 100);
  testing::add_ball(balls, 12'345, 6'789, 99, 100);
  for (int n = 0; n < 2000; ++n) {
    testing::add_ball(balls, testing::random_int(random, 0, 12'345),
                      testing::random_int(random, 0, 6'789), testing::random_int(random, 0, 99),
                      testing::random_int(random, 50, 100));
  }
  return balls;
}

TupleGrid grid_of(const BallSet& balls, TupleGridKind kind) {
  TupleGrid grid(std::pmr::get_default_resource());
  make_tuple_grid(balls, balls.lattice.alpha_on_lattice(0), {}, kind, grid);
  return grid;
}

// The slots of each cell are those whose records lie in it. Each slot occurs once.
void expect_sorted(const BallSet& balls, const TupleGrid& grid) {
  const TupleGridView& v = grid.view;
  ASSERT_EQ(grid.cell_start.size(),
            static_cast<std::size_t>(v.cells[0]) * v.cells[1] * v.cells[2] + 1);
  EXPECT_EQ(grid.cell_start.front(), 0u);
  EXPECT_EQ(grid.cell_start.back(), grid.size());
  std::vector<bool> seen(balls.size(), false);
  for (std::size_t c = 0; c + 1 < grid.cell_start.size(); ++c) {
    for (std::uint32_t s = grid.cell_start[c]; s < grid.cell_start[c + 1]; ++s) {
      const BallIndex i = grid.ball[s];
      EXPECT_FALSE(seen[i]);
      seen[i] = true;
      const LatticePoint& p = balls.centres[i];
      EXPECT_EQ(grid.records[s].x, p.x);
      EXPECT_EQ(grid.records[s].radius, balls.radii[i]);
      const std::int64_t at[] = {p.x, p.y, p.z};
      std::int64_t cell = 0;
      for (int a = 0; a < 3; ++a) cell = cell * v.cells[a] + (at[a] - v.origin[a]) / v.width[a];
      EXPECT_EQ(static_cast<std::size_t>(cell), c);
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), static_cast<long>(balls.size()));
}

// The thesis has a hundred cells along each axis. The last one ends behind the last ball.
TEST(TupleGrid, OfTheThesisHasAHundredCellsAnAxis) {
  const BallSet balls = box_of_balls();
  const TupleGrid grid = grid_of(balls, TupleGridKind::thesis);
  const int width[] = {124, 68, 1};
  for (int a = 0; a < 3; ++a) {
    EXPECT_EQ(grid.view.cells[a], 100);
    EXPECT_EQ(grid.view.width[a], width[a]);
    EXPECT_EQ(grid.view.origin[a], 0);
  }
  expect_sorted(balls, grid);
}

// Cells are half as wide as the searched cube, so a search visits few cells.
TEST(TupleGrid, IsAsWideAsNeighboursAreFar) {
  const BallSet balls = box_of_balls();
  const TupleGrid grid = grid_of(balls, TupleGridKind::automatic);
  EXPECT_EQ(grid.largest_radius, 100);
  EXPECT_GE(grid.largest_reach, 100);
  EXPECT_LT(grid.largest_reach, 100.1);
  for (int a = 0; a < 3; ++a) {
    EXPECT_GE(grid.view.width[a], 200);
    EXPECT_LE(grid.view.width[a], 210);
  }
  EXPECT_EQ(grid.view.cells[0], 12'345 / grid.view.width[0] + 1);
  EXPECT_EQ(grid.view.cells[1], 6'789 / grid.view.width[1] + 1);
  EXPECT_EQ(grid.view.cells[2], 1);
  expect_sorted(balls, grid);
}

}  // namespace
}  // namespace alphascope
