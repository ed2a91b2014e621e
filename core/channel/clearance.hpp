// Clearance: how far a point is from the nearest surface of a ball, min |x - c| - r (Å). Negative
// inside a ball. This is the true distance, not the power distance of the alpha complex.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/neighbours/uniform_grid.hpp"

namespace alphascope {

// The surface of one ball, as seen from a point.
struct Surface {
  double distance_angstrom;  // |x - c| - r
  BallIndex ball;
  RealPoint away;  // unit vector from its centre to the point; (0, 0, 0) at the centre
};

// The balls sorted into grids, one for each size of ball, so that a few large ones do not slow down
// the search among small ones. Rounded by some 1e-15 of the coordinates.
class Clearance {
 public:
  // Keeps nothing of `balls`.
  explicit Clearance(const BallSet& balls);

  // The nearest surface; of equal ones, that of the lowest index. There must be a ball.
  Surface nearest(const RealPoint& x_angstrom) const;
  double at(const RealPoint& x_angstrom) const { return nearest(x_angstrom).distance_angstrom; }

  // All surfaces at most so far away: by rising distance, then by index. Of balls with one centre
  // only the first of the largest counts: the others are within it.
  void collect(const RealPoint& x_angstrom, double most_angstrom, std::vector<Surface>& out) const;

 private:
  struct Level {
    UniformGrid grid;
    std::vector<BallIndex> ball;      // of the set, by the grid's own index
    std::vector<std::int32_t> radii;  // per slot, lattice units
    double most_radius = 0;
  };
  struct Query;

  std::vector<Level> levels_;
  double unit_ = 1;  // Å
};

}  // namespace alphascope
