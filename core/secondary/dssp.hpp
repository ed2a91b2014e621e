// SPDX-License-Identifier: GPL-3.0-or-later
// Secondary structure from hydrogen bonds: the definition of DSSP (W. Kabsch, C. Sander,
// Biopolymers 22, 2577-2637, 1983), with the rules of its version 4. There pi helices come before
// alpha helices, and stretches of polyproline II are found by torsion angles (R. P. Joosten et al.,
// Nucleic Acids Res. 39, D411-D419, 2011; M. L. Hekkelman et al., Protein Sci. 34, e70208, 2025).
#pragma once

#include <vector>

#include "core/molecule/secondary_structure.hpp"
#include "core/secondary/hydrogen_bonds.hpp"

namespace alphascope {

// One kind per residue. All residues must be complete.
std::vector<SecondaryStructure> dssp(const Molecule& molecule,
                                     const std::vector<BackboneResidue>& residues,
                                     const std::vector<HydrogenBonds>& bonds);

}  // namespace alphascope
