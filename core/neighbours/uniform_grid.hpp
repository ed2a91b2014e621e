// SPDX-License-Identifier: GPL-3.0-or-later
// Balls sorted into cubic cells, for neighbour search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

// The balls that are not empty at alpha (weight + alpha >= 0), in the order of cells. A slot is an
// index in this order. Cells are wider than the largest distance at which two balls may meet. So
// all neighbours of a ball are in the 27 cells around it. The cells of one (x, y) column are
// contiguous.
struct UniformGrid {
  std::vector<std::uint32_t> cell_start;  // first slot of each cell; one more entry than cells
  std::vector<BallIndex> ball;            // per slot
  // Per slot: centre, lattice units, and grown_reach(). Longer by kVectorRoom (meeting_slots.hpp).
  std::vector<std::int32_t> x, y, z;
  std::vector<float> reach;
  LatticePoint origin;    // lower corner of cell (0, 0, 0)
  double cell_width = 1;  // lattice units
  int nx = 0, ny = 0, nz = 0;

  std::size_t size() const { return ball.size(); }
  // The cell of a point, which must be within the box of all centres.
  struct Cell {
    int x, y, z;
  };
  Cell cell_at(const LatticePoint& p) const {
    return {std::min(cell_of(p.x, origin.x), nx - 1), std::min(cell_of(p.y, origin.y), ny - 1),
            std::min(cell_of(p.z, origin.z), nz - 1)};
  }
  // Calls visit(first slot, end of slots) for each row of a cell and the 26 around it.
  template <class Visit>
  void for_rows_around(const Cell& cell, const Visit& visit) const {
    const int z0 = std::max(cell.z - 1, 0), z1 = std::min(cell.z + 1, nz - 1);
    for (int ax = std::max(cell.x - 1, 0); ax <= std::min(cell.x + 1, nx - 1); ++ax) {
      for (int ay = std::max(cell.y - 1, 0); ay <= std::min(cell.y + 1, ny - 1); ++ay) {
        const std::size_t row = (static_cast<std::size_t>(ax) * ny + ay) * nz;
        visit(cell_start[row + z0], cell_start[row + z1 + 1]);
      }
    }
  }
  // Number of distance tests, of a ball with a candidate, that a search for all balls makes.
  double search_cost() const;

 private:
  int cell_of(std::int32_t coordinate, std::int32_t lower) const {
    return static_cast<int>((static_cast<double>(coordinate) - lower) / cell_width);
  }
};

// Makes the grid. `hidden` marks balls to leave out, which coincide with a larger one; it may be
// empty.
UniformGrid make_uniform_grid(const BallSet& balls, const LatticeAlpha& alpha_on_lattice,
                              const std::vector<bool>& hidden);

}  // namespace alphascope
