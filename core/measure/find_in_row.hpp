// SPDX-License-Identifier: GPL-3.0-or-later
// Finds an edge in the sorted edges of one ball. Host and device.
#pragma once

#include <cstddef>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/host_device.hpp"

namespace alphascope {

// The edge to ball j among the edges [low, high) of one lower ball; it must exist. upper(e) is the
// upper ball of edge e.
template <class Upper>
ALPHASCOPE_INLINE std::size_t find_in_row(std::size_t low, std::size_t high, BallIndex j,
                                          const Upper& upper) {
  while (high - low > 8) {
    const std::size_t middle = (low + high) / 2;
    (upper(middle) <= j ? low : high) = middle;
  }
  while (upper(low) < j) ++low;
  return low;
}

}  // namespace alphascope
