// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the cells of the tuple engine's grid and sorts the balls into them.
#include "core/tuples/tuple_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

constexpr int kThesisCells = 100;  // along each axis
// Bounds the memory for cells by the number of balls, however sparse they are.
constexpr double kMaxCellsPerBall = 4.0;

struct Extent {
  std::int64_t low[3], high[3];
  std::int64_t size(int axis) const { return high[axis] - low[axis]; }
};

Extent extent_of(const std::vector<BallRecord>& records) {
  Extent e;
  std::fill_n(e.low, 3, std::numeric_limits<std::int64_t>::max());
  std::fill_n(e.high, 3, std::numeric_limits<std::int64_t>::min());
  for (const BallRecord& b : records) {
    const std::int64_t p[3] = {b.x, b.y, b.z};
    for (int a = 0; a < 3; ++a) {
      e.low[a] = std::min(e.low[a], p[a]);
      e.high[a] = std::max(e.high[a], p[a]);
    }
  }
  return e;
}

void choose_cells(const Extent& extent, std::int64_t half_side, TupleGridKind kind,
                  std::size_t balls, TupleGridView& view) {
  double width = static_cast<double>(std::max<std::int64_t>(half_side, 1));
  const auto cells = [&](int axis) {
    return std::floor(static_cast<double>(extent.size(axis)) / width) + 1;
  };
  while (cells(0) * cells(1) * cells(2) > kMaxCellsPerBall * static_cast<double>(balls) + 64) {
    width = std::ceil(width * 1.25);
  }
  for (int a = 0; a < 3; ++a) {
    view.origin[a] = static_cast<std::int32_t>(extent.low[a]);
    if (kind == TupleGridKind::thesis) {
      view.cells[a] = kThesisCells;
      view.width[a] = static_cast<std::int32_t>(extent.size(a) / kThesisCells + 1);
    } else {
      view.cells[a] = static_cast<std::int32_t>(cells(a));
      view.width[a] = static_cast<std::int32_t>(std::min(width, 1073741824.0));
    }
  }
}

// A counting sort by cell, cell_index = (cell_x · cells_y + cell_y) · cells_z + cell_z.
void sort_into_cells(const std::vector<BallRecord>& records, const std::vector<BallIndex>& ball,
                     TupleGrid& grid) {
  const TupleGridView& v = grid.view;
  grid.cell_start.assign(static_cast<std::size_t>(v.cells[0]) * v.cells[1] * v.cells[2] + 1, 0);
  std::vector<std::uint32_t> cell(records.size());
  for (std::size_t n = 0; n < records.size(); ++n) {
    const BallRecord& b = records[n];
    cell[n] = static_cast<std::uint32_t>(
        (v.cell(0, b.x) * v.cells[1] + v.cell(1, b.y)) * v.cells[2] + v.cell(2, b.z));
    ++grid.cell_start[cell[n] + 1];
  }
  for (std::size_t c = 1; c < grid.cell_start.size(); ++c) {
    grid.cell_start[c] += grid.cell_start[c - 1];
  }
  std::vector<std::uint32_t> next(grid.cell_start.begin(), grid.cell_start.end() - 1);
  grid.records.resize(records.size());
  grid.ball.resize(records.size());
  for (std::size_t n = 0; n < records.size(); ++n) {
    const std::uint32_t slot = next[cell[n]]++;
    grid.records[slot] = records[n];
    grid.ball[slot] = ball[n];
  }
}

}  // namespace

void make_tuple_grid(const BallSet& balls, const LatticeAlpha& alpha,
                     const std::vector<bool>& hidden, TupleGridKind kind, TupleGrid& grid) {
  std::vector<BallRecord> records;
  std::vector<BallIndex> ball;
  records.reserve(balls.size());
  ball.reserve(balls.size());
  grid.largest_radius = 0;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const bool dead = alpha.plus(balls.weight(i)) < 0;
    if (dead || (!hidden.empty() && hidden[i])) continue;
    const LatticePoint& p = balls.centres[i];
    records.push_back({p.x, p.y, p.z, balls.radii[i]});
    ball.push_back(i);
    grid.largest_radius = std::max(grid.largest_radius, balls.radii[i]);
  }
  grid.records.clear();
  if (records.empty()) return;

  const auto reach = [&](std::int32_t radius) {
    return grown_reach(alpha.plus(std::int64_t{radius} * radius));
  };
  grid.largest_reach = reach(grid.largest_radius);
  const Extent extent = extent_of(records);
  const std::int64_t widest = std::max({extent.size(0), extent.size(1), extent.size(2)});
  const std::int64_t half_side = cube_half_side(grid.largest_reach, grid.largest_reach);
  grid.largest_difference = std::min(half_side, widest);
  choose_cells(extent, half_side, kind, records.size(), grid.view);
  sort_into_cells(records, ball, grid);
  grid.reach.resize(grid.records.size());
  for (std::size_t n = 0; n < grid.reach.size(); ++n) grid.reach[n] = reach(grid.records[n].radius);
}

}  // namespace alphascope
