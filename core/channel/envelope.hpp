// Roughly, the convex hull of the centres of balls: what is outside it is in the open.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// The hull is within it; it is larger by a few per cent, as it has only so many sides.
class Envelope {
 public:
  explicit Envelope(const BallSet& balls);
  bool holds(const RealPoint& x_angstrom) const;
  // From a point that it does not hold: a unit vector along which all centres are left behind.
  RealPoint outwards(const RealPoint& x_angstrom) const;

 private:
  static constexpr std::size_t kSides = 96;
  struct Side {
    RealPoint outwards;
    double most;  // Å along it
  };
  std::array<Side, kSides> sides_;
};

}  // namespace alphascope
