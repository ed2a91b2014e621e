// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of least power distance at a point, found in one pass over all balls.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// A point given as the vector from a ball's centre. Lattice units.
struct PointAtBall {
  BallIndex ball;
  RealPoint offset;
};

// Returns for each point up to `count` balls other than `without` (ascending), by rising power
// distance. Powers are compared in double precision, so the result is only a proposal and decides
// nothing.
std::vector<std::vector<BallIndex>> nearest_by_power(const BallSet& balls,
                                                     std::span<const PointAtBall> points,
                                                     std::span<const BallIndex> without,
                                                     std::size_t count);

}  // namespace alphascope
