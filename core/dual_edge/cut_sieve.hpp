// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts of one dual edge by many balls at once, by vector instructions of the processor at hand.
// Most balls cut off nothing of an edge, or all of it. The others are left to DualEdge::clip().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/dual_edge/dual_edge.hpp"
#include "core/dual_edge/triangle_faces.hpp"

namespace alphascope {

// Lifted vectors as doubles, one array a coordinate. The arrays are longer by kRoom, because
// vectors are read whole.
struct LiftedColumns {
  static constexpr std::size_t kRoom = 8;
  std::vector<double> x, y, z, c;

  void resize(std::size_t count) {
    for (auto* column : {&x, &y, &z, &c}) column->resize(count + kRoom);
  }
  void set(std::size_t k, const LiftedVector<double>& v) {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
    c[k] = v.c;
  }
  LiftedVector<double> operator[](std::size_t k) const { return {x[k], y[k], z[k], c[k]}; }
};

// A line of equal power as PowerLine<double>, with the part of it that is left: |s| <= reach.
struct SievedEdge {
  Vector3<double> direction, foot;
  double slope_error, offset_error, reach;
};

// `bits`: the balls that may cut, one bit each, in `words` words of 32. Those that certainly cut
// off nothing of the edge are cleared. Returns whether one of them certainly cuts off all; the bits
// are then undefined. The results are those of DualEdge<double>::takes().
bool sieve_cuts(const SievedEdge& edge, const LiftedColumns& balls, std::uint32_t* bits, int words);

// TriangleRows whose balls go through the sieve first. `bits` has room for a row.
struct SievedRows : TriangleRows {
  const LiftedColumns* balls;
  std::uint32_t* bits;
};

template <class Lifted, class Sink = NoSink>
bool clips_away(DualEdge<double>& edge, const SievedRows& t, int words, const Lifted& lifted,
                const Sink& sink = {}) {
  for (int w = 0; w < words; ++w) t.bits[w] = t.common(w);
  const SievedEdge sieved{edge.direction(), edge.foot(), edge.slope_error(), edge.offset_error(),
                          edge.reach()};
  return sieve_cuts(sieved, *t.balls, t.bits, words) ||
         clips_away(
             edge, words, [&](int w) { return t.bits[w]; }, lifted, sink);
}

}  // namespace alphascope
