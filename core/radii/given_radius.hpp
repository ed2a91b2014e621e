// SPDX-License-Identifier: GPL-3.0-or-later
// Radii on the lattice of the balls. Sets, tables and users give them in 10^-6 Å.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// The radius in lattice units, at least 1, and the change by rounding (Å).
struct LatticeRadius {
  std::int32_t units;
  double rounding_angstrom;
};
LatticeRadius on_lattice(std::int32_t microangstrom, const Lattice& lattice);

// A ball whose given radius is no multiple of its lattice unit.
struct RoundedBall {
  BallIndex ball;
  std::int32_t microangstrom;
};

struct RadiusRounding {
  std::size_t balls = 0;
  double largest_angstrom = 0;
};

// Puts the balls on the coarsest lattice that holds all given radii exactly. If the bounds leave no
// room for it, takes the finest possible lattice. Returns the number of radii that are still
// rounded, and the largest change.
RadiusRounding fit_lattice(BallSet& balls, const std::vector<RoundedBall>& rounded);

}  // namespace alphascope
