// The grid of the tuple engine, made on the host as in the thesis (section 3.2.2): balls sorted by
// cell, each array back to back.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/tuples/tuple_options.hpp"
#include "core/tuples/tuple_scene.hpp"

namespace alphascope {

// The balls that are not empty at alpha (weight + alpha >= 0) in cell order; a slot is a place in
// it.
// The arrays lie in `memory`: an executor that copies them to a device may want them page-locked.
struct TupleGrid {
  explicit TupleGrid(std::pmr::memory_resource* memory)
      : records(memory), reach(memory), ball(memory), cell_start(memory) {}

  std::pmr::vector<BallRecord> records;
  std::pmr::vector<float> reach;     // per slot: grown_reach()
  std::pmr::vector<BallIndex> ball;  // index in the BallSet
  std::pmr::vector<std::uint32_t> cell_start;
  TupleGridView view{};     // its cell_start is left to the executor
  float largest_reach = 0;  // lattice units
  // Bounds on coordinate differences of neighbours, and on radii; lattice units.
  std::int64_t largest_difference = 0;
  std::int32_t largest_radius = 0;

  std::uint32_t size() const { return static_cast<std::uint32_t>(records.size()); }
};

// Fills `grid`, whose memory is used again. `hidden` marks balls to leave out (coincident with a
// larger one); may be empty.
void make_tuple_grid(const BallSet& balls, const LatticeAlpha& alpha_on_lattice,
                     const std::vector<bool>& hidden, TupleGridKind kind, TupleGrid& grid);

}  // namespace alphascope
