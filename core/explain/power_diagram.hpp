// SPDX-License-Identifier: GPL-3.0-or-later
// The power diagram of a few balls as polygons: the borders between cells, cut off at a box. It is
// computed in double precision for pictures only and decides no membership.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// The common border of two balls' cells.
struct PowerFace {
  BallIndex a = 0, b = 0;                   // a < b
  std::vector<RealPoint> corners_angstrom;  // corners of a convex polygon, in order
};

// The largest number of balls that is drawn, because the time is O(n³).
inline constexpr std::size_t kMostBallsOfDiagram = 200;

// The faces by a, then b. The box contains all balls and a margin. Returns nothing for more balls
// than the bound. Among balls with one centre only one has a cell.
std::vector<PowerFace> power_diagram(const BallSet& balls);

}  // namespace alphascope
