// Going up to a place in a plane that is locally farthest from all balls: where a sphere that may
// move in the plane only is caught, nearly always between three balls.
#pragma once

#include "core/channel/clearance.hpp"

namespace alphascope {

struct AscentLimits {
  double longest_step_angstrom = 0.2;
  // Less than a millionth of an Å: as often as it takes to be that near to the place.
  double shortest_step_angstrom = 1e-7;
  double most_clearance_angstrom;  // the ascent ends where it is reached
  double farthest_angstrom;        // from the start; the ascent ends there
};

struct Ascent {
  RealPoint place;
  bool settled = false;  // at a local maximum; otherwise a limit ended it
};

// From x (Å), in the plane through x normal to the unit vector `normal`. Clearance only rises.
Ascent ascend_in_plane(const Clearance& clearance, const RealPoint& x, const RealPoint& normal,
                       const AscentLimits& limits);

}  // namespace alphascope
