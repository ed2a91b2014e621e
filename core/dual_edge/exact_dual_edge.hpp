// SPDX-License-Identifier: GPL-3.0-or-later
// Dual edges in exact integers, for the triangles that dual_edge.hpp leaves undecided. Host and
// device.
#pragma once

#include "core/predicates/orthocentre_cut.hpp"
#include "core/predicates/recording.hpp"
#include "core/predicates/simplex_decisions.hpp"

namespace alphascope {

// The ghost on one side of the line of ijk (+1: along d_j × d_k). It is the axis-parallel plane at
// distance g from p_i that the line crosses most steeply.
ALPHASCOPE_HOST_DEVICE inline EndBall ghost_end(const LiftedInt& j, const LiftedInt& k, int side,
                                                std::int64_t g) {
  const auto n = cross(j, k);
  const auto size = [](std::int64_t v) { return v < 0 ? -v : v; };
  const auto along = [&](std::int64_t v) { return v < 0 ? -side : side; };
  const std::int64_t x = size(n.x), y = size(n.y), z = size(n.z);
  if (x >= y && x >= z) return {-1, {along(n.x), 0, 0, 2 * g}};
  if (y >= z) return {-1, {0, along(n.y), 0, 2 * g}};
  return {-1, {0, 0, along(n.z), 2 * g}};
}

// Finds the ends of the dual edge of ijk after the cuts of its common neighbours. False when
// nothing is left, or when the three centres are collinear (then ijk is no simplex). `next(m)` is
// the common neighbour after m, starting with next(-1), or -1 after the last. `sink` gets the slots
// of both ends, or the slot of the ball that removes the rest.
template <class Integer, class Neighbours, class Next, class Sink = NoSink>
ALPHASCOPE_HOST_DEVICE bool exact_ends(const Neighbourhood<Neighbours>& in, int j, int k,
                                       const Next& next, EndBall& high, EndBall& low,
                                       const Sink& sink = {}) {
  const LiftedInt vj = in.neighbours.lifted(j), vk = in.neighbours.lifted(k);
  const auto n = cross(vj, vk);
  if (n.x == 0 && n.y == 0 && n.z == 0) return false;
  high = ghost_end(vj, vk, 1, in.ghost_reach);
  low = ghost_end(vj, vk, -1, in.ghost_reach);
  for (int m = next(-1); m >= 0; m = next(m)) {
    const LiftedInt vm = in.neighbours.lifted(m);
    const int side = sign_of(determinant(vj, vk, vm));
    if (side == 0) continue;
    EndBall& end = side > 0 ? high : low;
    if (orthocentre_cut<Integer>(vj, vk, end, vm) > 0) end = {m, vm};
  }
  // A ball that bounds the other side, or whose plane is parallel to the line, may still cut off
  // everything.
  for (int m = next(-1); m >= 0; m = next(m)) {
    if (m != high.slot && orthocentre_cut<Integer>(vj, vk, high, in.neighbours.lifted(m)) > 0) {
      sink(m);
      return false;
    }
  }
  sink(high.slot, low.slot);
  return true;
}

}  // namespace alphascope
