// SPDX-License-Identifier: GPL-3.0-or-later
// Clearance: how far a point is from the nearest surface of a ball, min |x - c| - r (Å). Negative
// inside a ball. This is the true distance, not the power distance of the alpha complex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// The surface of one ball as seen from a point.
struct Surface {
  double distance_angstrom;  // |x - c| - r
  BallIndex ball;
  RealPoint away;  // unit vector from the ball's centre to the point; (0, 0, 0) at the centre
};

// Holds the balls in a binary tree of boxes around centres. A search skips each box that, even with
// its largest radius, is too far away. So wide voids and a few large balls do not slow it down.
// Relative rounding error of coordinates: about 1e-15.
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
  friend class ClearanceNearby;

  // A ball. Lattice units.
  struct Slot {
    LatticePoint centre;
    std::int32_t radius;
    BallIndex ball;  // index in the ball set
  };
  // The slots [first, end). The first part of a node that is no leaf is the next node, its second
  // part the node `second`. A leaf has `second` 0. Lattice units.
  struct Node {
    LatticePoint low, high;  // of the centres
    std::int32_t most_radius;
    std::uint32_t first, end, second;
  };

  void build(std::uint32_t first, std::uint32_t end);
  static double square_distance(const RealPoint& x, const Node& node);
  // Visits each leaf that may be at most `most` away from x, nearer parts first. The visit may
  // lower `most`. Lattice units.
  template <class Visit>
  void visit_leaves(const RealPoint& x, const double& most, const Visit& visit) const;

  std::vector<Slot> slots_;
  std::vector<Node> nodes_;
  double unit_ = 1;  // length of a lattice unit, Å
};

// The same for many points near one place after another. It searches only the balls around a place,
// and keeps them for the next place if that is near. Its results are exactly those of Clearance.
class ClearanceNearby {
 public:
  // The Clearance must outlive this object.
  explicit ClearanceNearby(const Clearance& clearance) : clearance_(clearance) {}
  // Returns the clearance at x. The functions below may then be asked about all surfaces that are,
  // from x, at most `around_angstrom` farther away than the nearest one.
  double look_around(const RealPoint& x_angstrom, double around_angstrom);
  double at(const RealPoint& x_angstrom) const;
  // Sets `out` to the first `count` surfaces that Clearance::collect() finds.
  void collect(const RealPoint& x_angstrom, double most_angstrom, std::size_t count,
               std::vector<Surface>& out);

 private:
  struct Near {
    double distance_angstrom;
    std::uint32_t slot;  // index in slots_
  };

  const Clearance& clearance_;
  // All balls at most `most_` from `middle_`, where clearance is `value_`. Å.
  std::vector<Clearance::Slot> slots_;
  RealPoint middle_;
  double value_ = 0, most_ = -1;
  std::vector<Near> near_;  // of the last collect()
};

}  // namespace alphascope
