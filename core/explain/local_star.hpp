// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulation of a few balls that has the same simplices around a given simplex as that of all
// balls.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// If the simplex is in `triangulation`, it is in that of all balls. So is every simplex that
// contains it, with the same neighbours. If it is not in `triangulation`, it is in neither.
struct LocalStar {
  std::vector<BallIndex> chosen;  // ascending; local ball n is ball chosen[n]
  std::shared_ptr<const BallSet> balls;
  Triangulation triangulation;

  BallIndex local(BallIndex ball) const {
    const auto at = std::lower_bound(chosen.begin(), chosen.end(), ball);
    return static_cast<BallIndex>(at - chosen.begin());
  }
  template <class Simplex>
  std::vector<BallIndex> all(const Simplex& local_balls) const {
    std::vector<BallIndex> result;
    for (const BallIndex v : local_balls) result.push_back(chosen[v]);
    return result;
  }
};

// `first` holds balls that are likely to be needed, in any order, including those of the simplex.
// `simplex` is ascending. Throws Cancelled.
LocalStar local_star(const BallSet& balls, std::span<const BallIndex> simplex,
                     std::vector<BallIndex> first, const RunContext& context);

}  // namespace alphascope
