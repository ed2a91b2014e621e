// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the uniform grid: chooses the width of the cells and sorts the balls into them.
#include "core/neighbours/uniform_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/meeting_slots.hpp"
#include "core/predicates/grown_balls.hpp"

namespace alphascope {
namespace {

// The width of a cell, relative to the distance at which the two largest balls touch. Two balls
// that pass the test of grown_balls.hpp are nearer than 1 + 2^-18 + 10 u times that distance. This
// is below 1 + 4.5e-6. A coordinate is below 2^30 cells, so the division in cell_at() errs by less
// than 2^-22 of a cell, 2.4e-7. So the two balls are in the same cell or in neighbouring cells.
constexpr double kReachMargin = 1.0 + 1e-5;

// Bounds the memory for cells by the number of balls, however sparse they are.
constexpr double kMaxCellsPerBall = 4.0;

struct Box {
  LatticePoint low{std::numeric_limits<std::int32_t>::max(),
                   std::numeric_limits<std::int32_t>::max(),
                   std::numeric_limits<std::int32_t>::max()};
  LatticePoint high{std::numeric_limits<std::int32_t>::min(),
                    std::numeric_limits<std::int32_t>::min(),
                    std::numeric_limits<std::int32_t>::min()};
  void add(const LatticePoint& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

double cells_along(std::int32_t low, std::int32_t high, double width) {
  return std::floor((static_cast<double>(high) - low) / width) + 1;
}

// The balls that go into the grid: neither hidden nor empty at alpha.
struct AliveBalls {
  std::vector<BallIndex> indices;
  Box box;                      // box of their centres
  double max_reach_square = 0;  // squared radius of the largest grown ball
};

AliveBalls find_alive(const BallSet& balls, const LatticeAlpha& alpha_on_lattice,
                      const std::vector<bool>& hidden) {
  AliveBalls alive;
  alive.indices.reserve(balls.size());
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const double square = alpha_on_lattice.plus(balls.weight(i));
    if (square < 0 || (!hidden.empty() && hidden[i])) continue;
    alive.indices.push_back(i);
    alive.box.add(balls.centres[i]);
    alive.max_reach_square = std::max(alive.max_reach_square, square);
  }
  return alive;
}

// Chooses the cells.
void set_cells(const AliveBalls& alive, UniformGrid& grid) {
  const LatticePoint low = alive.box.low, high = alive.box.high;
  double width = std::max(1.0, 2 * std::sqrt(alive.max_reach_square) * kReachMargin);
  const auto cells = [&] {
    return cells_along(low.x, high.x, width) * cells_along(low.y, high.y, width) *
           cells_along(low.z, high.z, width);
  };
  const double most = kMaxCellsPerBall * static_cast<double>(alive.indices.size()) + 64;
  while (cells() > most) width *= 1.25;
  grid.origin = low;
  grid.cell_width = width;
  grid.nx = static_cast<int>(cells_along(low.x, high.x, width));
  grid.ny = static_cast<int>(cells_along(low.y, high.y, width));
  grid.nz = static_cast<int>(cells_along(low.z, high.z, width));
}

// Fills cell_start by a counting sort, and returns the slot of each ball.
std::vector<std::uint32_t> sort_into_cells(const BallSet& balls,
                                           const std::vector<BallIndex>& indices,
                                           UniformGrid& grid) {
  const std::size_t cell_count = static_cast<std::size_t>(grid.nx) * grid.ny * grid.nz;
  grid.cell_start.assign(cell_count + 1, 0);
  std::vector<std::uint32_t> cell(indices.size());
  for (std::size_t a = 0; a < indices.size(); ++a) {
    const UniformGrid::Cell c = grid.cell_at(balls.centres[indices[a]]);
    const std::size_t row = static_cast<std::size_t>(c.x) * grid.ny + c.y;
    cell[a] = static_cast<std::uint32_t>(row * grid.nz + c.z);
    ++grid.cell_start[cell[a] + 1];
  }
  for (std::size_t c = 0; c < cell_count; ++c) grid.cell_start[c + 1] += grid.cell_start[c];
  std::vector<std::uint32_t> next(grid.cell_start.begin(), grid.cell_start.end() - 1);
  for (std::uint32_t& c : cell) c = next[c]++;
  return cell;
}

}  // namespace

double UniformGrid::search_cost() const {
  double cost = 0;
  for (int cx = 0; cx < nx; ++cx) {
    for (int cy = 0; cy < ny; ++cy) {
      for (int cz = 0; cz < nz; ++cz) {
        const std::size_t cell = (static_cast<std::size_t>(cx) * ny + cy) * nz + cz;
        const double own = static_cast<double>(cell_start[cell + 1] - cell_start[cell]);
        if (own == 0) continue;
        double around = 0;
        for_rows_around({cx, cy, cz}, [&](std::uint32_t begin, std::uint32_t end) {
          around += static_cast<double>(end - begin);
        });
        cost += own * around;
      }
    }
  }
  return cost;
}

UniformGrid make_uniform_grid(const BallSet& balls, const LatticeAlpha& alpha_on_lattice,
                              const std::vector<bool>& hidden) {
  const AliveBalls alive = find_alive(balls, alpha_on_lattice, hidden);
  const std::size_t count = alive.indices.size();
  UniformGrid grid;
  if (count == 0) {
    grid.cell_start = {0};
    return grid;
  }
  set_cells(alive, grid);
  const std::vector<std::uint32_t> slots = sort_into_cells(balls, alive.indices, grid);
  grid.ball.resize(count);
  grid.x.resize(count + kVectorRoom);
  grid.y.resize(count + kVectorRoom);
  grid.z.resize(count + kVectorRoom);
  grid.reach.resize(count + kVectorRoom);
  for (std::size_t a = 0; a < count; ++a) {
    const std::uint32_t slot = slots[a];
    const BallIndex i = alive.indices[a];
    grid.ball[slot] = i;
    grid.x[slot] = balls.centres[i].x;
    grid.y[slot] = balls.centres[i].y;
    grid.z[slot] = balls.centres[i].z;
    grid.reach[slot] = grown_reach(alpha_on_lattice.plus(balls.weight(i)));
  }
  return grid;
}

}  // namespace alphascope
