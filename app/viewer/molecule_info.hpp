// The open molecule as the panels show it. Pure functions: no window, no GL.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

MoleculeInfo describe_molecule(const OpenedMolecule& opened);

// Elements with their radii, grown by the solvent radius (Å) and alpha (Å²), most frequent first.
std::vector<GrownRadius> grown_radii(const PreparedBalls& prepared, const Request& controls);

}  // namespace alphascope
