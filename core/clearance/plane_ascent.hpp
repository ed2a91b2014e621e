// SPDX-License-Identifier: GPL-3.0-or-later
// Ascent in a plane to a local maximum of clearance. A sphere that may move only in the plane is
// caught there, nearly always between three balls.
#pragma once

#include "core/clearance/clearance.hpp"

namespace alphascope {

struct AscentLimits {
  double longest_step_angstrom = 0.2;
  // The ascent ends when the step is shorter. The default gets within a millionth of an Å of the
  // maximum.
  double shortest_step_angstrom = 1e-7;
  double most_clearance_angstrom;  // the ascent ends where clearance reaches this
  double farthest_angstrom;        // the ascent ends at this distance from its start

  AscentLimits with_steps_scaled(double by) const {
    return {by * longest_step_angstrom, by * shortest_step_angstrom, most_clearance_angstrom,
            by * farthest_angstrom};
  }
};

struct Ascent {
  RealPoint place;
  double clearance_angstrom = 0;  // there
  bool settled = false;           // true at a local maximum; false if a limit ended the ascent
};

// Starts at x (Å) and stays in the plane through x normal to the unit vector `normal`. Clearance
// never falls.
Ascent ascend_in_plane(const Clearance& clearance, const RealPoint& x, const RealPoint& normal,
                       const AscentLimits& limits);
// The same for one start after another that are near each other.
Ascent ascend_in_plane(ClearanceNearby& nearby, const RealPoint& x, const RealPoint& normal,
                       const AscentLimits& limits);

}  // namespace alphascope
