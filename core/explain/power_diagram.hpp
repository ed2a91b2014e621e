// The power diagram of a few balls as polygons: the borders between their cells, cut at a box. Only
// a picture, in doubles; what is in a complex is decided elsewhere.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// What two balls share of the borders of their cells.
struct PowerFace {
  BallIndex a = 0, b = 0;                   // a < b
  std::vector<RealPoint> corners_angstrom;  // of a convex polygon, in its order
};

// More balls are not drawn: it takes O(n³).
inline constexpr std::size_t kMostBallsOfDiagram = 200;

// By a, then b. The box is that of all balls, larger by a share of its diagonal. Of more balls than
// the bound: none. Of balls with one centre only one has a cell.
std::vector<PowerFace> power_diagram(const BallSet& balls);

}  // namespace alphascope
