// Words of selection expressions that look at more than one atom: one value an atom of the
// molecule.
#pragma once

#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/selection/selection_program.hpp"

namespace alphascope {

// `which`: protein, nucleic, backbone or sidechain. A residue of a polymer is of a protein when its
// name is an amino acid's or it has atoms N and CA; of a nucleic acid when its name is a
// nucleotide's or it has an atom C1'. Backbone are N, CA, C, O, OXT and the hydrogens at N and CA;
// phosphate and sugar. Sidechain is the rest of these residues.
std::vector<bool> atoms_of_polymers(const Molecule& molecule, SelectionTest which);

// Atoms whose centre is at most so far from the centre of one of `around`, in the same model.
// Exact: squares of whole numbers are compared.
std::vector<bool> atoms_within(const Molecule& molecule, const std::vector<bool>& around,
                               std::int64_t microangstrom);

// All atoms of the residues (the chains of one model) that have one of these.
std::vector<bool> whole_residues(const Molecule& molecule, std::vector<bool> atoms);
std::vector<bool> whole_chains(const Molecule& molecule, const std::vector<bool>& atoms);

}  // namespace alphascope
