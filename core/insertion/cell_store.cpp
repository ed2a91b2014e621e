// SPDX-License-Identifier: GPL-3.0-or-later
// Hands out blocks, and moves the cells when they need more room.
#include "core/insertion/cell_store.hpp"

#include <algorithm>

#include "core/complex/count_limits.hpp"

namespace alphascope {

CellBlock CellStore::take_block() {
  const std::size_t begin = taken_.fetch_add(kBlockCells, std::memory_order_relaxed);
  if (begin + kBlockCells > cells_.size()) {
    taken_.fetch_sub(kBlockCells, std::memory_order_relaxed);
    return {};
  }
  for (std::size_t c = begin; c < begin + kBlockCells; ++c) cells_[c].state = Cell::kFree;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + kBlockCells)};
}

void CellStore::make_room(std::size_t cells) {
  const std::size_t blocks = (cells + kBlockCells - 1) / kBlockCells;
  cells_.resize(std::min(blocks * kBlockCells, kMostCells));
}

void CellStore::double_room() {
  if (cells_.size() == kMostCells) require_at_most(2 * cells_.size(), kMostCells, "tetrahedra");
  make_room(2 * cells_.size());
}

}  // namespace alphascope
