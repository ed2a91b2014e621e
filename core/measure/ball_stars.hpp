// SPDX-License-Identifier: GPL-3.0-or-later
// The neighbours of balls in a triangulation, found on request.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/complex/triangulation.hpp"

namespace alphascope {

// One tetrahedron of each ball; 0 for hidden balls.
inline std::vector<std::uint32_t> tetrahedron_of_balls(const Triangulation& triangulation,
                                                       std::size_t balls) {
  std::vector<std::uint32_t> of(balls, 0);
  for (std::size_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
    for (const BallIndex i : triangulation.tetrahedra[t]) of[i] = static_cast<std::uint32_t>(t);
  }
  return of;
}

// For one thread. Results are kept for later calls.
class BallStars {
 public:
  BallStars(const Triangulation& triangulation, const std::vector<std::uint32_t>& tetrahedron_of)
      : triangulation_(triangulation),
        tetrahedron_of_(tetrahedron_of),
        walk_of_(triangulation.tetrahedra.size(), 0) {}

  // The neighbours of ball i, ascending. Valid until the next call.
  std::span<const BallIndex> neighbours(BallIndex i) {
    const auto [at, is_new] = range_of_.try_emplace(i);
    if (is_new) at->second = walk(i);
    return {found_.data() + at->second.first, at->second.count};
  }

 private:
  struct Range {
    std::size_t first, count;
  };
  Range walk(BallIndex i) {
    const std::size_t first = found_.size();
    ++walks_;
    star_.clear();
    const auto meet = [&](std::uint32_t t) {
      if (std::exchange(walk_of_[t], walks_) != walks_) star_.push_back(t);
    };
    meet(tetrahedron_of_[i]);
    for (std::size_t n = 0; n < star_.size(); ++n) {
      const std::uint32_t t = star_[n];
      for (int k = 0; k < 4; ++k) {
        const BallIndex ball = triangulation_.tetrahedra[t][k];
        if (ball == i) continue;
        found_.push_back(ball);
        const Neighbour across = triangulation_.neighbours[t][k];
        if (!across.is_hull()) meet(across.index());
      }
    }
    const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, found_.end());
    found_.erase(std::unique(begin, found_.end()), found_.end());
    return {first, found_.size() - first};
  }

  const Triangulation& triangulation_;
  const std::vector<std::uint32_t>& tetrahedron_of_;
  std::vector<std::uint32_t> walk_of_;  // per tetrahedron: the last walk that met it
  std::uint32_t walks_ = 0;
  std::unordered_map<BallIndex, Range> range_of_;
  std::vector<BallIndex> found_;
  std::vector<std::uint32_t> star_;
};

}  // namespace alphascope
