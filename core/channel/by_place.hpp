// SPDX-License-Identifier: GPL-3.0-or-later
// An order of balls by position, then radius. It does not depend on the order in the file. Rounded
// computations use it, so that their result is the same for every order of the input.
#pragma once

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

inline std::vector<BallIndex> sorted_by_place(const BallSet& balls) {
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), BallIndex{0});
  const auto key = [&](BallIndex i) {
    const LatticePoint& p = balls.centres[i];
    return std::tuple(p.x, p.y, p.z, balls.radii[i], i);
  };
  std::sort(order.begin(), order.end(), [&](BallIndex a, BallIndex b) { return key(a) < key(b); });
  return order;
}

// The given balls, all or some, in this order.
inline BallSet in_order(const BallSet& balls, const std::vector<BallIndex>& order) {
  BallSet result;
  result.lattice = balls.lattice;
  for (const BallIndex ball : order) {
    result.centres.push_back(balls.centres[ball]);
    result.radii.push_back(balls.radii[ball]);
  }
  return result;
}

}  // namespace alphascope
