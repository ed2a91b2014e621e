// SPDX-License-Identifier: GPL-3.0-or-later
// The memory of all cells. Several threads may take blocks of it at the same time.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/complex/simplices.hpp"
#include "core/insertion/cell.hpp"

namespace alphascope {

// A range of cells that nobody uses.
struct CellBlock {
  std::uint32_t begin = 0, end = 0;
};

class CellStore {
 public:
  // An index and a corner share 32 bits.
  static constexpr std::size_t kMostCells = std::size_t{1} << 30;
  static constexpr std::uint32_t kBlockCells = 256;

  // Room for at least so many cells, if kMostCells are not fewer. Throws std::bad_alloc.
  explicit CellStore(std::size_t room) { make_room(room); }

  Cell* data() { return cells_.data(); }
  const Cell* data() const { return cells_.data(); }
  std::size_t taken() const { return std::min<std::size_t>(taken_.load(), cells_.size()); }

  // An empty block when there is no room. The cells are marked as free.
  CellBlock take_block();

  // Keeps the cells. Not while others use the store. Throws std::bad_alloc, and std::length_error
  // beyond kMostCells.
  void double_room();

 private:
  void make_room(std::size_t cells);

  ResultArray<Cell> cells_;
  std::atomic<std::size_t> taken_{0};
};

}  // namespace alphascope
