// Decides once for all formats what each residue is: polymer, ligand, ion, water or dummy. Evidence
// is used in a fixed order: the entity table, other records (bonds last), the residue's own atoms,
// lists of names. The rest is guessed.
#pragma once

#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// Sets Atom::kind and Atom::why. Atoms must be on the lattice, and have the kind that their names
// suggest. Dummies stay dummies. Models with the same atoms get the same kinds. Notes report
// guesses, and evidence that disagrees.
void decide_residues(Molecule& molecule, const ResidueRecords& records);

}  // namespace alphascope
