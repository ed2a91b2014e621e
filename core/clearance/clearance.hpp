// SPDX-License-Identifier: GPL-3.0-or-later
// Clearance: how far a point is from the nearest surface of a ball, min |x - c| - r (Å). Negative
// inside a ball. This is the true distance, not the power distance of the alpha complex.
#pragma once

#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/neighbours/uniform_grid.hpp"

namespace alphascope {

struct BallSet;

// The surface of one ball as seen from a point.
struct Surface {
  double distance_angstrom;  // |x - c| - r
  BallIndex ball;
  RealPoint away;  // unit vector from the ball's centre to the point; (0, 0, 0) at the centre
};

// Holds the balls in one grid for each size class. So a few large balls do not slow down the search
// among small ones. Relative rounding error of coordinates: about 1e-15.
class Clearance {
 public:
  // Copies all it needs of `balls`.
  explicit Clearance(const BallSet& balls);

  // The nearest surface; if several are equally near, that of the lowest index. Needs at least one
  // ball.
  Surface nearest(const RealPoint& x_angstrom) const;
  double at(const RealPoint& x_angstrom) const { return nearest(x_angstrom).distance_angstrom; }

  // Sets `out` to all surfaces at most `most_angstrom` away, by rising distance, then by index.
  // Among balls with equal centres only the first of the largest counts, because the others lie
  // within it.
  void collect(const RealPoint& x_angstrom, double most_angstrom, std::vector<Surface>& out) const;

 private:
  struct Level {
    UniformGrid grid;
    std::vector<BallIndex> ball;      // index in the ball set, by the grid's own index
    std::vector<std::int32_t> radii;  // of each slot, lattice units
    double most_radius = 0;
  };
  struct Query;

  std::vector<Level> levels_;
  double unit_ = 1;  // length of a lattice unit, Å
};

}  // namespace alphascope
