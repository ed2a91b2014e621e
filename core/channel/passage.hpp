// SPDX-License-Identifier: GPL-3.0-or-later
// The widest passage between two places outside a set of balls. Its width is how far all radii can
// grow before the places are separated. The answer is exact. Each tested growth takes a
// triangulation of all grown balls.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/clearance/clearance.hpp"
#include "core/clearance/grown_triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct PassageGap {
  RealPoint place_angstrom;
  double clearance_angstrom;
  bool at_wall;  // true: between two balls and the plane; false: between three balls
};

struct Passage {
  // The ends are in one component outside the balls of radii r + widest. With radii r + widest +
  // step they are not. Negative if the ends are cut off without any growth. A ball whose radius
  // shrinks to 0 is dropped.
  std::int64_t widest = 0;
  // Whether one step more would cover an end.
  bool ends_decide = false;
  // From `from` to `to`, or to far away, outside the balls of radii r + widest (Å).
  std::vector<RealPoint> curve;
  // The gaps on the curve, in its order. The curve is narrowest in one of them or at an end.
  std::vector<PassageGap> gaps;
  int triangulations = 0;
};

// The step of growths: 0.001 Å, or the lattice's unit if that is longer. In lattice units.
std::int64_t passage_step(const Lattice& lattice);

// The largest growth, a multiple of the step, that leaves this point outside all balls. Negative if
// the point lies in a ball without any growth.
std::int64_t growth_room(const BallSet& balls, const LatticePoint& point);

// Needs `balls` on a lattice that passage_digits() allows, and their clearance. Works in the
// caller's task arena; the result does not depend on the number of threads. Throws Cancelled.
Passage widest_passage(const BallSet& balls, const Clearance& clearance, const PassageEnds& ends,
                       const RunContext& context = {});

}  // namespace alphascope
