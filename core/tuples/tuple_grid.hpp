// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of the tuple engine: arrays of balls sorted by cell. The host makes it, as in the thesis
// (section 3.2.2).
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/tuples/tuple_input.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// The balls that are not empty at alpha (weight + alpha >= 0), in the order of cells. A slot is an
// index in this order. The arrays are allocated from `memory`, because an executor that copies them
// to a device may want page-locked memory.
struct TupleGrid {
  explicit TupleGrid(std::pmr::memory_resource* memory)
      : records(memory), reach(memory), ball(memory), cell_start(memory) {}

  std::pmr::vector<BallRecord> records;
  std::pmr::vector<float> reach;     // grown_reach(), lattice units
  std::pmr::vector<BallIndex> ball;  // index in the BallSet
  std::pmr::vector<std::uint32_t> cell_start;
  TupleGridView view{};     // the executor sets its cell_start
  float largest_reach = 0;  // lattice units
  // Bounds on coordinate differences of neighbours, and on radii; lattice units.
  std::int64_t largest_difference = 0;
  std::int32_t largest_radius = 0;

  std::uint32_t size() const { return static_cast<std::uint32_t>(records.size()); }
};

// Fills `grid` and reuses its memory. `hidden` marks balls to leave out, which coincide with a
// larger one; it may be empty.
void make_tuple_grid(const BallSet& balls, const LatticeAlpha& alpha_on_lattice,
                     const std::vector<bool>& hidden, TupleGridKind kind, TupleGrid& grid);

}  // namespace alphascope
