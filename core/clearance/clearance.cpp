// SPDX-License-Identifier: GPL-3.0-or-later
// Clearance of points by grids. Balls of similar size share a grid, and a search visits its cells
// in growing shells.
#include "core/clearance/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

// Balls of one grid differ by no more than this factor.
constexpr int kRadiusFactor = 4;

// Visits the slots of the cells (x, y, low_z) to (x, y, high_z) that exist.
template <class Visit>
void visit_column(const UniformGrid& grid, int x, int y, int low_z, int high_z,
                  const Visit& visit) {
  low_z = std::max(low_z, 0);
  high_z = std::min(high_z, grid.nz - 1);
  if (x < 0 || x >= grid.nx || y < 0 || y >= grid.ny || low_z > high_z) return;
  const std::size_t column = (static_cast<std::size_t>(x) * static_cast<std::size_t>(grid.ny) +
                              static_cast<std::size_t>(y)) *
                             static_cast<std::size_t>(grid.nz);
  const std::uint32_t end = grid.cell_start[column + static_cast<std::size_t>(high_z) + 1];
  for (std::uint32_t s = grid.cell_start[column + static_cast<std::size_t>(low_z)]; s < end; ++s) {
    visit(s);
  }
}

// The cell of a coordinate. A coordinate outside the grid gets the cell one beyond its border.
int clamped_cell(double coordinate, double origin, double width, int count) {
  return static_cast<int>(
      std::clamp(std::floor((coordinate - origin) / width), -1.0, static_cast<double>(count)));
}

// Balls by falling radius. Among balls with equal centres only the largest with the lowest index is
// kept. A million of them would share one cell.
std::vector<BallIndex> by_falling_radius(const BallSet& balls) {
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), BallIndex{0});
  const auto is_larger = [&](BallIndex a, BallIndex b) {
    return balls.radii[a] != balls.radii[b] ? balls.radii[a] > balls.radii[b] : a < b;
  };
  std::sort(order.begin(), order.end(), [&](BallIndex a, BallIndex b) {
    return balls.centres[a] != balls.centres[b] ? balls.centres[a] < balls.centres[b]
                                                : is_larger(a, b);
  });
  order.erase(
      std::unique(order.begin(), order.end(),
                  [&](BallIndex a, BallIndex b) { return balls.centres[a] == balls.centres[b]; }),
      order.end());
  std::sort(order.begin(), order.end(), is_larger);
  return order;
}

}  // namespace

// A point in lattice units, and its cell.
struct Clearance::Query {
  const Level& level;
  RealPoint x;
  int cx, cy, cz;

  Query(const Level& of, const RealPoint& at) : level(of), x(at) {
    const UniformGrid& g = of.grid;
    cx = clamped_cell(at.x, g.origin.x, g.cell_width, g.nx);
    cy = clamped_cell(at.y, g.origin.y, g.cell_width, g.ny);
    cz = clamped_cell(at.z, g.origin.z, g.cell_width, g.nz);
  }
  double distance(std::uint32_t slot) const {
    const UniformGrid& g = level.grid;
    const double dx = x.x - g.x[slot], dy = x.y - g.y[slot], dz = x.z - g.z[slot];
    return std::sqrt(dx * dx + dy * dy + dz * dz) - level.radii[slot];
  }
  // Visits all balls in cells whose largest offset from the point's cell, along any axis, is
  // `shell`.
  template <class Visit>
  void visit_shell(int shell, const Visit& visit) const {
    const UniformGrid& g = level.grid;
    const int x_end = std::min(shell, g.nx - 1 - cx), y_end = std::min(shell, g.ny - 1 - cy);
    for (int dx = std::max(-shell, -cx); dx <= x_end; ++dx) {
      for (int dy = std::max(-shell, -cy); dy <= y_end; ++dy) {
        if (std::abs(dx) == shell || std::abs(dy) == shell) {
          visit_column(g, cx + dx, cy + dy, cz - shell, cz + shell, visit);
        } else {
          visit_column(g, cx + dx, cy + dy, cz - shell, cz - shell, visit);
          visit_column(g, cx + dx, cy + dy, cz + shell, cz + shell, visit);
        }
      }
    }
  }
  // A lower bound of the distance from the point to any centre in that shell or beyond.
  double shell_distance(int shell) const {
    const UniformGrid& g = level.grid;
    const auto gap = [&](double at, double origin, int cell) {
      const double inside = at - origin - cell * g.cell_width;
      return std::min(inside, g.cell_width - inside);
    };
    // A point outside the grid may lie beyond its clamped cell. The bound then loses one shell.
    const double inner = std::min({gap(x.x, g.origin.x, cx), gap(x.y, g.origin.y, cy),
                                   gap(x.z, g.origin.z, cz), g.cell_width});
    return (shell - 1) * g.cell_width + std::max(inner, 0.0);
  }
  int last_shell() const { return std::max({level.grid.nx, level.grid.ny, level.grid.nz}) + 1; }
};

Clearance::Clearance(const BallSet& balls) : unit_(balls.lattice.unit_angstrom()) {
  const std::vector<BallIndex> order = by_falling_radius(balls);
  for (std::size_t begin = 0; begin < order.size();) {
    const std::int32_t most = balls.radii[order[begin]];
    std::size_t end = begin;
    while (end < order.size() && balls.radii[order[end]] > most / kRadiusFactor) ++end;
    Level level;
    level.most_radius = most;
    level.ball.assign(order.begin() + static_cast<std::ptrdiff_t>(begin),
                      order.begin() + static_cast<std::ptrdiff_t>(end));
    BallSet part;
    part.lattice = balls.lattice;
    for (const BallIndex i : level.ball) {
      part.centres.push_back(balls.centres[i]);
      part.radii.push_back(balls.radii[i]);
    }
    level.grid = make_uniform_grid(part, 0, {});
    level.radii.reserve(part.size());
    for (const BallIndex own : level.grid.ball) level.radii.push_back(part.radii[own]);
    levels_.push_back(std::move(level));
    begin = end;
  }
}

Surface Clearance::nearest(const RealPoint& x_angstrom) const {
  const RealPoint x = (1 / unit_) * x_angstrom;
  double best = std::numeric_limits<double>::infinity();
  BallIndex ball = 0;
  RealPoint centre;
  for (const Level& level : levels_) {
    const Query query(level, x);
    for (int shell = 0; shell <= query.last_shell(); ++shell) {
      if (shell > 0 && query.shell_distance(shell) - level.most_radius > best) break;
      query.visit_shell(shell, [&](std::uint32_t slot) {
        const double distance = query.distance(slot);
        const BallIndex index = level.ball[level.grid.ball[slot]];
        if (distance > best || (distance == best && index > ball)) return;
        best = distance;
        ball = index;
        centre = {static_cast<double>(level.grid.x[slot]), static_cast<double>(level.grid.y[slot]),
                  static_cast<double>(level.grid.z[slot])};
      });
    }
  }
  return {best * unit_, ball, unit_vector(x - centre)};
}

void Clearance::collect(const RealPoint& x_angstrom, double most_angstrom,
                        std::vector<Surface>& out) const {
  out.clear();
  const RealPoint x = (1 / unit_) * x_angstrom;
  const double most = most_angstrom / unit_;
  for (const Level& level : levels_) {
    const UniformGrid& g = level.grid;
    const double reach = most + level.most_radius;
    if (!(reach >= 0)) continue;
    const auto cell = [&](double at, double origin, int count) {
      return clamped_cell(at, origin, g.cell_width, count);
    };
    const Query query(level, x);
    const int x_end = cell(x.x + reach, g.origin.x, g.nx);
    const int y_end = cell(x.y + reach, g.origin.y, g.ny);
    for (int cx = cell(x.x - reach, g.origin.x, g.nx); cx <= x_end; ++cx) {
      for (int cy = cell(x.y - reach, g.origin.y, g.ny); cy <= y_end; ++cy) {
        visit_column(
            g, cx, cy, cell(x.z - reach, g.origin.z, g.nz), cell(x.z + reach, g.origin.z, g.nz),
            [&](std::uint32_t slot) {
              const double distance = query.distance(slot);
              if (distance > most) return;
              const RealPoint centre{static_cast<double>(g.x[slot]), static_cast<double>(g.y[slot]),
                                     static_cast<double>(g.z[slot])};
              out.push_back({distance * unit_, level.ball[g.ball[slot]], unit_vector(x - centre)});
            });
      }
    }
  }
  std::sort(out.begin(), out.end(), [](const Surface& a, const Surface& b) {
    return a.distance_angstrom != b.distance_angstrom ? a.distance_angstrom < b.distance_angstrom
                                                      : a.ball < b.ball;
  });
}

}  // namespace alphascope
