// Which balls have the least power distance at a point: one pass over all of them.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// A point, as the vector from a ball's centre. Lattice units.
struct PointAtBall {
  BallIndex ball;
  RealPoint offset;
};

// For each point up to `count` balls other than `without` (ascending), those of the least power
// first. Powers are compared in double precision: this proposes, and decides nothing.
std::vector<std::vector<BallIndex>> nearest_by_power(const BallSet& balls,
                                                     std::span<const PointAtBall> points,
                                                     std::span<const BallIndex> without,
                                                     std::size_t count);

}  // namespace alphascope
