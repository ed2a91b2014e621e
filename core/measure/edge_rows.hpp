// SPDX-License-Identifier: GPL-3.0-or-later
// Finds an edge or triangle in the sorted lists of a complex.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/measure/find_in_row.hpp"

namespace alphascope {

// For each ball, the index of the first edge of which it is the lower ball.
class EdgeRows {
 public:
  EdgeRows() = default;
  EdgeRows(std::size_t balls, const Simplices<2>& edges) : first_(balls + 1, 0) {
    std::size_t ball = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (; ball <= edges[e][0]; ++ball) first_[ball] = static_cast<std::uint32_t>(e);
    }
    for (; ball <= balls; ++ball) first_[ball] = static_cast<std::uint32_t>(edges.size());
  }
  // The index of edge ij, i < j, which must exist.
  std::size_t find(const Simplices<2>& edges, BallIndex i, BallIndex j) const {
    return find_in_row(first_[i], first_[i + 1], j, [&](std::size_t e) { return edges[e][1]; });
  }

 private:
  std::vector<std::uint32_t> first_;
};

// The index of a triangle, which must exist.
inline std::size_t find_triangle(const Simplices<3>& triangles,
                                 const std::array<BallIndex, 3>& balls) {
  return static_cast<std::size_t>(std::lower_bound(triangles.begin(), triangles.end(), balls) -
                                  triangles.begin());
}

}  // namespace alphascope
