// SPDX-License-Identifier: GPL-3.0-or-later
// How much room blocks get beyond the mean of what earlier runs met.
#pragma once

#include <algorithm>
#include <cstdint>

namespace alphascope::gpu {

// Factors of the room beyond the mean, see room_for() in room.cuh. With more room fewer balls go to
// kernel III, but fewer blocks fit on a multiprocessor. Runs that left up to
// half of the balls that kernel III may take were no slower on an H200: it works beside the next
// chunk.
inline constexpr double kUsualMargin = 1.2, kMostMargin = 2, kMarginStep = 1.1;

// The margin after a run that left `deferred` balls to kernel III, and `too_long` of them because
// of the length of their lists. `limit` is DualEdgeProblem::deferred_limit. The margin comes down
// again where few balls are left: at another alpha it would only take room.
inline double next_margin(double margin, std::uint32_t deferred, std::uint32_t too_long,
                          std::uint32_t limit) {
  if (deferred - too_long > limit / 2) {
    return std::max(margin, std::min(kMarginStep * margin, kMostMargin));
  }
  const bool few = deferred < limit / 8;
  return few && margin > kUsualMargin ? std::max(kUsualMargin, margin / kMarginStep) : margin;
}

}  // namespace alphascope::gpu
