// SPDX-License-Identifier: GPL-3.0-or-later
// The atom types of AutoDock and Vina, as PDBQT files have them in columns 78-79.
#pragma once

#include "core/read/residues/stated_element.hpp"

namespace alphascope {

// The element of a type: "A" (aromatic carbon), "OA", "HD", "Cl". Case matters: "NA" is a nitrogen
// that accepts hydrogen bonds, "Na" is sodium. The glue "G0", "TZ" and "W" are no atoms.
StatedElement autodock_element(std::string_view type);

}  // namespace alphascope
