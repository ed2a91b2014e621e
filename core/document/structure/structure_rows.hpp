// SPDX-License-Identifier: GPL-3.0-or-later
// The residues of the drawn models as a tree: chains of polymers, then ligands, ions, waters and
// dummies. A derived result that follows from the balls alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/molecule/residue_kind.hpp"
#include "core/molecule/secondary_structure.hpp"

namespace alphascope {

template <class T>
struct Definition;
struct ModelRange;
struct Molecule;
struct RunContext;
struct SecondaryModel;

// Twelve bytes, since an assembly may have millions of waters.
struct ResidueRow {
  std::uint32_t first = 0, end = 0;  // atoms of Molecule::atoms
  char letter = 'X';                 // of an amino acid or nucleotide; X: another residue
  SecondaryStructure secondary = SecondaryStructure::coil;
};

struct ResidueBranch {
  std::string title;  // "Chain A", "Ligands"
  ResidueKind kind = ResidueKind::polymer;
  std::size_t begin = 0, end = 0;  // in StructureRows::residues
  std::size_t size() const { return end - begin; }
};

struct StructureRows {
  std::vector<ResidueRow> residues;  // branch by branch, each in the order of the atoms
  std::vector<ResidueBranch> branches;
  // The row of the residue that has this atom; empty: the atom is of another model.
  std::optional<std::size_t> row_of(std::uint32_t atom) const;
  // Rows by their first atom, ascending; empty where `residues` has that order itself.
  std::vector<std::uint32_t> by_atom;
};

// Chains come in the order of their first residues. A residue ends where its number, its chain or
// its name changes. Throws Cancelled.
StructureRows make_structure_rows(const Molecule& molecule, const ModelRange& models,
                                  const SecondaryModel& secondary, const RunContext& context);

// "HIS 87" of a polymer, "HEM 142, chain A" of others.
std::string residue_title(const Molecule& molecule, const ResidueRow& row);

const Definition<StructureRows>& structure_rows();

}  // namespace alphascope
