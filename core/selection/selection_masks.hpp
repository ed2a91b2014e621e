// SPDX-License-Identifier: GPL-3.0-or-later
// Words of selection expressions that depend on more than one atom. Results have one value for each
// atom of the molecule.
#pragma once

#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/selection/selection_program.hpp"

namespace alphascope {

// `which`: protein, nucleic, backbone or sidechain. A polymer's residue is of a protein if its name
// is an amino acid's, or if it has N and CA. It is of a nucleic acid if its name is a nucleotide's
// or it has an atom C1'. The backbone is N, CA, C, O, OXT and the hydrogens at N and CA; or
// phosphate and sugar. The sidechain is the rest of such residues.
std::vector<bool> atoms_of_polymers(const Molecule& molecule, SelectionTest which);

// Atoms whose centre is at most `microangstrom` (10^-6 Å) from the centre of one of `around`, in
// the same model. Exact: squares of whole numbers are compared.
std::vector<bool> atoms_within(const Molecule& molecule, const std::vector<bool>& around,
                               std::int64_t microangstrom);

// All atoms of the residues, or of one model's chains, that contain one of these atoms.
std::vector<bool> whole_residues(const Molecule& molecule, std::vector<bool> atoms);
std::vector<bool> whole_chains(const Molecule& molecule, const std::vector<bool>& atoms);

}  // namespace alphascope
