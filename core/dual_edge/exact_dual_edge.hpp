// SPDX-License-Identifier: GPL-3.0-or-later
// Dual edges in exact integers, for the triangles that dual_edge.hpp leaves undecided. Host and
// device.
#pragma once

#include "core/predicates/perturbation.hpp"
#include "core/predicates/recording.hpp"
#include "core/predicates/simplex_decisions.hpp"

namespace alphascope {

// Int128 is wide enough for orthocentre_cut() if |d_x| < 2^17 and |c| < 2^36: then |d_j × d_k| <
// 2^35, its products with c and d_m are < 2^88, and twelve of them < 2^92. WideInt<4> is wide
// enough for every lattice: 2^61 and 2^154.
inline constexpr std::int64_t kSmallOffset = std::int64_t{1} << 17,
                              kSmallPower = std::int64_t{1} << 36;

// A ball that ends a dual edge. Slot -1 is a ghost: a plane without weight, beyond all points with
// pi_i <= alpha.
struct EndBall {
  int slot;
  LiftedInt lifted;
};

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

// +1 when ball m cuts off the orthocentre x of ijkl, else -1; the perturbation breaks ties. With
// D = det(d_j, d_k, d_l), not 0: 2 D x = c_j d_k × d_l + c_k d_l × d_j + c_l d_j × d_k.
template <class Integer>
ALPHASCOPE_HOST_DEVICE int orthocentre_cut(const LiftedInt& j, const LiftedInt& k,
                                           const EndBall& end, const LiftedInt& m) {
  const LiftedInt& l = end.lifted;
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const Integer cj(j.c), ck(k.c), cl(l.c);
  const Integer d =
      Integer(j.x) * Integer(kl.x) + Integer(j.y) * Integer(kl.y) + Integer(j.z) * Integer(kl.z);
  const Integer x = cj * Integer(kl.x) + ck * Integer(lj.x) + cl * Integer(jk.x);
  const Integer y = cj * Integer(kl.y) + ck * Integer(lj.y) + cl * Integer(jk.y);
  const Integer z = cj * Integer(kl.z) + ck * Integer(lj.z) + cl * Integer(jk.z);
  const Integer beyond = Integer(m.x) * x + Integer(m.y) * y + Integer(m.z) * z - Integer(m.c) * d;
  const int sign = sign_of(beyond) * sign_of(d);
  return sign != 0 ? sign : perturbed_cut(j, k, false, l, end.slot < 0, m);
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
