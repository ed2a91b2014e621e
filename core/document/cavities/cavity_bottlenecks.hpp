// SPDX-License-Identifier: GPL-3.0-or-later
// The bottlenecks of the cavities on screen, as a result.
#pragma once

#include <cstddef>
#include <vector>

#include "core/channel/bottlenecks.hpp"

namespace alphascope {

// The bottlenecks on the ways out of the cavities on screen, computed in the background.
struct CavityBottlenecks {
  // More rows would take minutes: each new value needs two triangulations.
  static constexpr std::size_t kMostRows = 100;
  std::vector<Bottleneck> rows;  // for the first rows of the CavityTable
};

}  // namespace alphascope
