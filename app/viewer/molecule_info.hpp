// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the open molecule for the panels. Pure functions: no window, no GL.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

struct GrownRadius;

MoleculeInfo describe_molecule(const OpenedMolecule& opened);

// Elements with their radii, the most frequent first. Radii are grown by the solvent radius (Å) and
// alpha (Å²).
std::vector<GrownRadius> grown_radii(const PreparedBalls& prepared, const Request& controls);

}  // namespace alphascope
