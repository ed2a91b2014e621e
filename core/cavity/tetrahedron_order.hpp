// SPDX-License-Identifier: GPL-3.0-or-later
// An order of tetrahedra by the positions of their centres, which does not depend on the order of
// the balls. It breaks all ties. So the same balls have the same cavities, numbers and names in
// whatever order a file lists them.
#pragma once

#include <algorithm>
#include <array>

#include "core/cavity/order_balls.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

// Returns whether `a` comes first: in lexicographic order of the ascending centres, exactly. Two
// different tetrahedra of one triangulation never have the same four centres.
inline bool comes_first(const BallSet& balls, const std::array<BallIndex, 4>& a,
                        const std::array<BallIndex, 4>& b) {
  const auto centres = [&](const std::array<BallIndex, 4>& of) {
    std::array<LatticePoint, 4> sorted{balls.centres[of[0]], balls.centres[of[1]],
                                       balls.centres[of[2]], balls.centres[of[3]]};
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const auto of_a = centres(a), of_b = centres(b);
  return of_a != of_b ? of_a < of_b : a < b;
}

// As order_balls().
template <std::size_t N>
std::array<unsigned, N> order_by_centres(const BallSet& balls,
                                         const std::array<BallIndex, N>& simplex) {
  unsigned order[N];
  order_balls(order, [&](unsigned a, unsigned b) {
    return balls.centres[simplex[a]] < balls.centres[simplex[b]];
  });
  std::array<unsigned, N> result;
  std::copy_n(order, N, result.begin());
  return result;
}

}  // namespace alphascope
