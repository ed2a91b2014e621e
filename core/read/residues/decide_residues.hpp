// What each residue is: polymer, ligand, ion, water or dummy, decided once for all formats when a
// file is read. In a fixed order the entity table is asked, other records (bonds last), the
// residue's own atoms, lists of names; what is left is guessed.
#pragma once

#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// Sets Atom::kind and Atom::why. The atoms have their places on the lattice, and the kind that
// their names alone say; dummies stay dummies. Models with the same atoms get the same answers.
// Notes say what was guessed, and where two pieces of evidence disagree.
void decide_residues(Molecule& molecule, const ResidueRecords& records);

}  // namespace alphascope
