// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of a triangle are attached to the ball that they lack, and which ends of an edge to
// its other end. In a regular triangulation no other balls need this test, also where there are
// ties. Host and device.
#pragma once

#include "core/predicates/foot_predicate.hpp"

namespace alphascope {

template <class Corners>
ALPHASCOPE_DEVICE_CALL bool is_edge_attached_exactly(const Corners& corners, unsigned lacking) {
  const unsigned i = lacking == 0 ? 1 : 0, j = lacking == 2 ? 1 : 2;
  return edge_foot_cut_exact(corners.lifted(i, j), corners.lifted(i, lacking)) > 0;
}

// Bit n for the edge without ball n of the triangle. `Corners` is as SimplexCorners.
template <class Corners>
ALPHASCOPE_HOST_DEVICE unsigned attached_edges(const Corners& corners) {
  const LiftedInt j = corners.lifted(0, 1), k = corners.lifted(0, 2);
  const LiftedInt jk{k.x - j.x, k.y - j.y, k.z - j.z, 0};
  signed char cut[3] = {0, 0, 0};
  if (within_bracket_limit(j) && within_bracket_limit(k) && within_bracket_limit(jk)) {
    const LiftedVector<double> between = lifted_as<double>(jk);
    edge_foot_cuts_filtered(lifted_as<double>(j), lifted_as<double>(k),
                            {between.x, between.y, between.z}, cut);
  }
  unsigned attached = 0;
  for (unsigned n = 0; n < 3; ++n) {
    if (cut[n] > 0 || (cut[n] == 0 && is_edge_attached_exactly(corners, n))) attached |= 1u << n;
  }
  return attached;
}

// Bit n for ball n of the edge: whether the other ball attaches it. `j` is the second ball, seen
// from the first.
ALPHASCOPE_HOST_DEVICE inline unsigned attached_ends(const LiftedInt& j) {
  const std::int64_t length = j.x * j.x + j.y * j.y + j.z * j.z;
  const bool first = j.c < 0, second = length + (length - j.c) < 0;  // c of the first ball, seen
  return (first ? 1u : 0u) | (second ? 2u : 0u);                     // from the second
}

}  // namespace alphascope
