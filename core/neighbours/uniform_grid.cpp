#include "core/neighbours/uniform_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/predicates/grown_balls.hpp"

namespace alphascope {
namespace {

// Of a cell's width over the distance at which the two largest balls touch. Two that pass the test
// of grown_balls.hpp are nearer than 1 + 2^-18 + 10 u of that, below 1 + 4.5e-6; and as a
// coordinate is below 2^30 cells, cell_of()'s division errs by less than 2^-22 of one, 2.4e-7. So
// they are in the same or in neighbouring cells.
constexpr double kReachMargin = 1.0 + 1e-5;

// Memory for cells stays proportional to the balls, however sparse they are.
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

}  // namespace

double UniformGrid::search_cost() const {
  double cost = 0;
  const auto count = [&](int cx, int cy, int z0, int z1) {
    const std::size_t row = (static_cast<std::size_t>(cx) * ny + cy) * nz;
    return static_cast<double>(cell_start[row + z1 + 1] - cell_start[row + z0]);
  };
  for (int cx = 0; cx < nx; ++cx) {
    for (int cy = 0; cy < ny; ++cy) {
      for (int cz = 0; cz < nz; ++cz) {
        const double own = count(cx, cy, cz, cz);
        if (own == 0) continue;
        double around = 0;
        for (int ax = std::max(cx - 1, 0); ax <= std::min(cx + 1, nx - 1); ++ax) {
          for (int ay = std::max(cy - 1, 0); ay <= std::min(cy + 1, ny - 1); ++ay) {
            around += count(ax, ay, std::max(cz - 1, 0), std::min(cz + 1, nz - 1));
          }
        }
        cost += own * around;
      }
    }
  }
  return cost;
}

UniformGrid make_uniform_grid(const BallSet& balls, double alpha_on_lattice,
                              const std::vector<bool>& hidden) {
  UniformGrid grid;
  Box box;
  std::vector<BallIndex> alive;
  alive.reserve(balls.size());
  double max_reach_square = 0;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const double square = static_cast<double>(balls.weight(i)) + alpha_on_lattice;
    if (square < 0 || (!hidden.empty() && hidden[i])) continue;
    alive.push_back(i);
    box.add(balls.centres[i]);
    max_reach_square = std::max(max_reach_square, square);
  }
  if (alive.empty()) {
    grid.cell_start = {0};
    return grid;
  }

  double width = std::max(1.0, 2 * std::sqrt(max_reach_square) * kReachMargin);
  const auto cells = [&] {
    return cells_along(box.low.x, box.high.x, width) * cells_along(box.low.y, box.high.y, width) *
           cells_along(box.low.z, box.high.z, width);
  };
  while (cells() > kMaxCellsPerBall * static_cast<double>(alive.size()) + 64) width *= 1.25;
  grid.origin = box.low;
  grid.cell_width = width;
  grid.nx = static_cast<int>(cells_along(box.low.x, box.high.x, width));
  grid.ny = static_cast<int>(cells_along(box.low.y, box.high.y, width));
  grid.nz = static_cast<int>(cells_along(box.low.z, box.high.z, width));

  // Counting sort by cell.
  const std::size_t cell_count = static_cast<std::size_t>(grid.nx) * grid.ny * grid.nz;
  grid.cell_start.assign(cell_count + 1, 0);
  std::vector<std::uint32_t> cell(alive.size());
  for (std::size_t a = 0; a < alive.size(); ++a) {
    const LatticePoint& p = balls.centres[alive[a]];
    const std::size_t cx = std::min(grid.cell_of(p.x, box.low.x), grid.nx - 1);
    const std::size_t cy = std::min(grid.cell_of(p.y, box.low.y), grid.ny - 1);
    const std::size_t cz = std::min(grid.cell_of(p.z, box.low.z), grid.nz - 1);
    cell[a] = static_cast<std::uint32_t>((cx * grid.ny + cy) * grid.nz + cz);
    ++grid.cell_start[cell[a] + 1];
  }
  for (std::size_t c = 0; c < cell_count; ++c) grid.cell_start[c + 1] += grid.cell_start[c];
  std::vector<std::uint32_t> next(grid.cell_start.begin(), grid.cell_start.end() - 1);
  grid.ball.resize(alive.size());
  grid.x.resize(alive.size());
  grid.y.resize(alive.size());
  grid.z.resize(alive.size());
  grid.reach.resize(alive.size());
  for (std::size_t a = 0; a < alive.size(); ++a) {
    const std::uint32_t slot = next[cell[a]]++;
    const BallIndex i = alive[a];
    grid.ball[slot] = i;
    grid.x[slot] = balls.centres[i].x;
    grid.y[slot] = balls.centres[i].y;
    grid.z[slot] = balls.centres[i].z;
    grid.reach[slot] = grown_reach(static_cast<double>(balls.weight(i)) + alpha_on_lattice);
  }
  return grid;
}

}  // namespace alphascope
