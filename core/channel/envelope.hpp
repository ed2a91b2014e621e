// SPDX-License-Identifier: GPL-3.0-or-later
// A polyhedron around the centres of balls, nearly their convex hull. Points outside it are in the
// open.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Contains the convex hull. It is larger by a few per cent, because it has only kSides sides.
class Envelope {
 public:
  explicit Envelope(const BallSet& balls);
  bool holds(const RealPoint& x_angstrom) const;
  // For a point outside: the unit vector of the side that the point is farthest beyond. All centres
  // are behind that side.
  RealPoint outwards(const RealPoint& x_angstrom) const;

 private:
  static constexpr std::size_t kSides = 96;
  struct Side {
    RealPoint outwards;
    double most;  // Å: largest coordinate of a centre along `outwards`
  };
  std::array<Side, kSides> sides_;
};

}  // namespace alphascope
