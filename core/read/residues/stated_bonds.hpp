// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the atoms of the bonds that a file states.
#pragma once

#include "core/molecule/molecule.hpp"
#include "core/read/residues/recorded_bonds.hpp"

namespace alphascope {

// Fills Molecule::stated_bonds, for each model. A bond to or from a metal is a coordination. A name
// stands for all alternative locations of an atom, and compatible ones are bonded. Counts
// bonds to atoms that are not in the file, and to serial numbers of several atoms. Bonds of
// components join the atoms of each residue of their name.
void state_bonds(Molecule& molecule, const RecordedBonds& bonds);

}  // namespace alphascope
