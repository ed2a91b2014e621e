// The widest passage between two places outside a set of balls: how far can all balls grow by one
// length until the places are cut off from each other? Exact; each answer takes the triangulation
// of all balls, grown.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/channel/clearance.hpp"
#include "core/channel/grown_scene.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct PassageGap {
  RealPoint place_angstrom;
  double clearance_angstrom;
  bool at_wall;  // between two balls and the plane, not between three balls
};

struct Passage {
  // The ends are in one component outside the balls of radii r + widest, not of r + widest + step.
  // Negative where they are cut off even as they are; a ball that shrinks to nothing is gone.
  std::int64_t widest = 0;
  // The ends themselves are covered by balls that grow one step more.
  bool ends_decide = false;
  // Outside the balls of r + widest: from `from` to `to`, or to far away (Å).
  std::vector<RealPoint> curve;
  // The gaps that the curve goes through, in its order; it is narrowest in one of them, or at an
  // end.
  std::vector<PassageGap> gaps;
  int triangulations = 0;
};

// `widest` is a multiple of it: 0.001 Å, or the lattice's unit if that is longer.
std::int64_t passage_step(const Lattice& lattice);

// Largest growth, a multiple of the step, that leaves this point outside all balls; negative when
// it is not outside them as they are.
std::int64_t growth_room(const BallSet& balls, const LatticePoint& point);

// `balls` on a lattice that passage_digits() allows, and their clearance. Works in the caller's
// task arena; what it finds does not depend on the number of threads. Throws Cancelled.
Passage widest_passage(const BallSet& balls, const Clearance& clearance, const PassageEnds& ends,
                       const RunContext& context = {});

}  // namespace alphascope
