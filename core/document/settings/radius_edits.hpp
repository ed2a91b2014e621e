// Radii that a user types in place of guessed or missing ones, in the order in which they were
// made: BallOptions::overrides with one radius a group of atoms.
#pragma once

#include <vector>

#include "core/selection/ball_options.hpp"

namespace alphascope {

using RadiusEdits = std::vector<RadiusOverride>;

// Rounded to 10^-6 Å. Outside of kBallRadiusRule nothing changes and false is returned.
bool set_radius(RadiusEdits& edits, const AtomGroup& atoms, double angstrom);
void reset_radius(RadiusEdits& edits, const AtomGroup& atoms);
const RadiusOverride* find_radius(const RadiusEdits& edits, const AtomGroup& atoms);

}  // namespace alphascope
