// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the lives of cavities between frames. Plain data.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/document/cavities/cavity_bars.hpp"

namespace alphascope {

struct CavityLines;
struct CavityLives;

// The longest lives, the results from which they were made, and their rows in the table now.
struct ShownLives {
  static constexpr std::size_t kNoRow = ~std::size_t{0};
  CavityBars bars;
  std::shared_ptr<const CavityLives> of;
  double from_angstrom2 = 0;
  std::shared_ptr<const CavityLines> lines;
  std::vector<std::size_t> rows;  // for each bar; kNoRow: its cavity is not in the table
};

}  // namespace alphascope
