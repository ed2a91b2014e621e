// SPDX-License-Identifier: GPL-3.0-or-later
// Radii that the user types for groups of atoms, in the order of typing (BallOptions::overrides).
// They replace guessed or missing ones.
#pragma once

#include <vector>

#include "core/selection/ball_options.hpp"

namespace alphascope {

using RadiusEdits = std::vector<RadiusOverride>;

// Rounds to 10^-6 Å. Outside kBallRadiusRule nothing is changed, and false is returned.
bool set_radius(RadiusEdits& edits, const AtomGroup& atoms, double angstrom);
void reset_radius(RadiusEdits& edits, const AtomGroup& atoms);
const RadiusOverride* find_radius(const RadiusEdits& edits, const AtomGroup& atoms);

}  // namespace alphascope
