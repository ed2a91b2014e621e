// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the widest walk between places of a fine grid by flooding it from above. It is a bound for
// channels that needs no triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope::testing {

// A cube around the origin. Steps lead to all 26 neighbours.
class FloodedGrid {
 public:
  FloodedGrid(const BallSet& balls, double spacing, double half_width)
      : spacing_(spacing), half_(static_cast<int>(std::lround(half_width / spacing))) {
    const int side = 2 * half_ + 1;
    const double unit = balls.lattice.unit_angstrom();
    clearance_.resize(static_cast<std::size_t>(side * side * side));
    for (std::size_t n = 0; n < clearance_.size(); ++n) {
      const RealPoint x = place(n);
      double least = std::numeric_limits<double>::infinity();
      for (BallIndex i = 0; i < balls.size(); ++i) {
        least = std::min(least,
                         length(x - unit * real_point(balls.centres[i])) - unit * balls.radii[i]);
      }
      clearance_[n] = least;
    }
  }

  // Bound of the error, Å. Every walk has a walk on the grid within half a cell's diagonal. Every
  // point of a step on the grid is within that distance of an end of the step. Rounding adds 0.001
  // Å.
  double error() const { return spacing_ * std::sqrt(3.0) / 2 + 0.001; }

  // Both places are rounded to the grid.
  double widest_between(const RealPoint& a, const RealPoint& b) const {
    const std::size_t to = at(b);
    return flood(
        a, [&](std::size_t n) { return n == to; }, [](const RealPoint&) { return true; });
  }
  double widest_out(const RealPoint& a) const {
    return flood(
        a, [&](std::size_t n) { return is_border(n); }, [](const RealPoint&) { return true; });
  }
  // The widest walk from a to the border of the cube, without going below a.
  double widest_up(const RealPoint& a) const {
    return flood(
        a, [&](std::size_t n) { return is_border(n); },
        [&](const RealPoint& x) { return x.z >= a.z - 1e-9; });
  }

 private:
  int side() const { return 2 * half_ + 1; }
  std::array<int, 3> cell(std::size_t n) const {
    const auto s = static_cast<std::size_t>(side());
    return {static_cast<int>(n % s), static_cast<int>(n / s % s), static_cast<int>(n / s / s)};
  }
  RealPoint place(std::size_t n) const {
    const auto [x, y, z] = cell(n);
    return spacing_ * RealPoint{static_cast<double>(x - half_), static_cast<double>(y - half_),
                                static_cast<double>(z - half_)};
  }
  std::size_t at(const RealPoint& p) const {
    const auto index = [&](double v) { return std::lround(v / spacing_) + half_; };
    return static_cast<std::size_t>((index(p.z) * side() + index(p.y)) * side() + index(p.x));
  }
  bool is_border(std::size_t n) const {
    const auto c = cell(n);
    return std::any_of(c.begin(), c.end(), [&](int v) { return v == 0 || v == 2 * half_; });
  }

  // Adds places by falling clearance until the set that contains a has an end.
  template <class IsEnd, class Allowed>
  double flood(const RealPoint& a, const IsEnd& is_end, const Allowed& allowed) const {
    std::vector<std::uint32_t> order(clearance_.size()), parent(clearance_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(parent.begin(), parent.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t m, std::uint32_t n) { return clearance_[m] > clearance_[n]; });
    std::vector<char> in(clearance_.size(), 0), ends(clearance_.size(), 0);
    const auto root = [&](std::uint32_t n) {
      while (parent[n] != n) n = parent[n] = parent[parent[n]];
      return n;
    };
    const auto from = static_cast<std::uint32_t>(at(a));
    for (const std::uint32_t n : order) {
      if (!allowed(place(n))) continue;
      in[n] = 1;
      ends[root(n)] |= is_end(n);
      const auto c = cell(n);
      for (int k = 0; k < 27; ++k) {
        const int x = c[0] + k % 3 - 1, y = c[1] + k / 3 % 3 - 1, z = c[2] + k / 9 - 1;
        if (std::min({x, y, z}) < 0 || std::max({x, y, z}) > 2 * half_) continue;
        const auto m = static_cast<std::uint32_t>((z * side() + y) * side() + x);
        if (!in[m]) continue;
        const std::uint32_t one = root(m), other = root(n);
        if (one == other) continue;
        ends[other] |= ends[one];
        parent[one] = other;
      }
      if (in[from] && ends[root(from)]) return clearance_[n];
    }
    return -std::numeric_limits<double>::infinity();
  }

  double spacing_;
  int half_;
  std::vector<double> clearance_;
};

}  // namespace alphascope::testing
