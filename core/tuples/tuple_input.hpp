// SPDX-License-Identifier: GPL-3.0-or-later
// The input of the tuple engine's kernels: balls sorted into a grid, the cube of neighbours of a
// ball, and tuples of neighbours. Host and device; the kernels are in tuple_body.hpp. Source: N. P.
// Ranjanikar's thesis, sections 3.2.2 to 3.2.5.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/predicates/grown_balls.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/predicates/recording.hpp"

namespace alphascope {

// A ball in lattice units. It has 16 bytes, so that reading it takes one load or one texel.
struct alignas(16) BallRecord {
  std::int32_t x, y, z, radius;
};

// Reads balls from plain memory. The CUDA executor has another reader, which uses textures.
struct PlainReader {
  const BallRecord* records;
  const float* reaches;
  ALPHASCOPE_INLINE BallRecord ball(std::uint32_t slot) const { return records[slot]; }
  // grown_reach() of the ball, lattice units.
  ALPHASCOPE_INLINE float reach(std::uint32_t slot) const { return reaches[slot]; }
};

// The cells of the grid, ordered by (x, y, z) with z fastest. So the balls of a range of z are
// contiguous.
struct TupleGridView {
  std::int32_t origin[3], width[3], cells[3];
  const std::uint32_t* cell_start;  // first slot of each cell, and the end

  // The index along `axis` of the cell with this coordinate, clamped to the grid.
  ALPHASCOPE_INLINE int cell(int axis, std::int64_t coordinate) const {
    const std::int64_t c = (coordinate - origin[axis]) / width[axis];
    return c < 0 ? 0 : c >= cells[axis] ? cells[axis] - 1 : static_cast<int>(c);
  }
};

template <class Reader>
struct TupleInput {
  Reader read;
  TupleGridView grid;
  const std::uint32_t* ball;  // index in the BallSet, per slot
  float largest_reach;
  LatticeAlpha alpha;
  float alpha_float;  // nearest float
  bool edge_optimisation, alpha_optimisation;
  bool alpha_covers_all;  // alpha is above every possible ortho-radius
  bool float_holds;       // differences and sums of radii of neighbours are exact in float
  bool int128_holds;      // see ExactCentre
};

// Half the side of the cube that holds the neighbours of a ball, lattice units: r + r_max of the
// grown radii. A ball outside cannot meet it (grown_balls.hpp: the sum is above the distance).
// Rounding down is right, because differences of coordinates are integers. They are below 2^30.
ALPHASCOPE_INLINE std::int32_t cube_half_side(float reach, float largest_reach) {
  const float side = reach + largest_reach;
  return side < 1.0e9f ? static_cast<std::int32_t>(side) : std::int32_t{1} << 30;
}

// Calls visit(slot) for all other balls with centres in the cube of `slot`, in ascending order.
// `sink` gets the slot of each ball that is tested.
template <class Reader, class Visit, class Sink = NoSink>
ALPHASCOPE_INLINE void for_balls_in_cube(const TupleInput<Reader>& scene, std::uint32_t slot,
                                         const Visit& visit, const Sink& sink = {}) {
  const TupleGridView& g = scene.grid;
  const BallRecord b = scene.read.ball(slot);
  const std::int64_t side = cube_half_side(scene.read.reach(slot), scene.largest_reach);
  const int x1 = g.cell(0, b.x + side), y0 = g.cell(1, b.y - side), y1 = g.cell(1, b.y + side),
            z0 = g.cell(2, b.z - side), z1 = g.cell(2, b.z + side);
  for (int x = g.cell(0, b.x - side); x <= x1; ++x) {
    for (int y = y0; y <= y1; ++y) {
      const std::int64_t row = (static_cast<std::int64_t>(x) * g.cells[1] + y) * g.cells[2];
      const std::uint32_t end = g.cell_start[row + z1 + 1];
      for (std::uint32_t t = g.cell_start[row + z0]; t < end; ++t) {
        sink(t);
        const BallRecord m = scene.read.ball(t);
        const bool inside = m.x - b.x <= side && b.x - m.x <= side && m.y - b.y <= side &&
                            b.y - m.y <= side && m.z - b.z <= side && b.z - m.z <= side;
        if (inside && t != slot) visit(t);
      }
    }
  }
}

template <class Reader>
ALPHASCOPE_INLINE bool grown_balls_may_meet(const TupleInput<Reader>& scene, std::uint32_t a,
                                            std::uint32_t b) {
  const BallRecord p = scene.read.ball(a), q = scene.read.ball(b);
  return grown_balls_may_meet(q.x - p.x, q.y - p.y, q.z - p.z, scene.read.reach(a),
                              scene.read.reach(b));
}

// The neighbours of the balls of one batch, ascending by slot, one list after the other.
struct NeighbourLists {
  const std::uint32_t* slots;
  const std::uint64_t* starts;  // for each ball of the whole set
  std::uint64_t base;           // starts[first ball of the batch]

  ALPHASCOPE_INLINE std::uint32_t begin(std::uint32_t slot) const {
    return static_cast<std::uint32_t>(starts[slot] - base);
  }
  ALPHASCOPE_INLINE std::uint32_t end(std::uint32_t slot) const {
    return static_cast<std::uint32_t>(starts[slot + 1] - base);
  }
};

// N balls: the one with the lowest slot, and the places of the others in its list, ascending. Each
// unordered tuple occurs once.
template <int N>
struct BallTuple {
  std::uint32_t first;
  std::uint32_t at[N > 1 ? N - 1 : 1];

  ALPHASCOPE_INLINE std::uint32_t slot(const NeighbourLists& lists, int n) const {
    return n == 0 ? first : lists.slots[at[n - 1]];
  }
};

// The lifted vector of ball m, seen from ball i.
ALPHASCOPE_INLINE LiftedInt lifted_from(const BallRecord& i, const BallRecord& m) {
  return lifted_vector(i, i.radius, m, m.radius);
}

}  // namespace alphascope
