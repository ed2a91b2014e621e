// SPDX-License-Identifier: GPL-3.0-or-later
// Decides once for all formats what each residue is: polymer, ligand, ion, water or dummy. Evidence
// has a fixed order. The entity table is first, then other records (bonds last). The residue's own
// atoms and lists of names follow. The rest is guessed.
#pragma once

#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// Sets Atom::kind and Atom::why. Atoms must be on the lattice, and have the kind that their names
// suggest. Dummies stay dummies. Models with the same atoms get the same kinds. Notes report
// guesses, and evidence that disagrees.
void decide_residues(Molecule& molecule, const ResidueRecords& records);

}  // namespace alphascope
