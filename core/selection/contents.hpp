// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a molecule in numbers, for lists from which people choose.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/molecule/residue_kind.hpp"

namespace alphascope {

struct Molecule;

// Numbers of atoms by kind; the index is a ResidueKind.
using KindCounts = std::array<std::size_t, 5>;

inline std::size_t of_kind(const KindCounts& counts, ResidueKind kind) {
  return counts[static_cast<std::size_t>(kind)];
}

// The kinds that occur: "polymer 1,069 · water 60".
std::string kinds_text(const KindCounts& counts);

struct ChainContents {
  std::string name;  // the author's name; empty: the file gives none
  std::size_t atoms = 0;
  KindCounts kinds{};
};

struct MoleculeContents {
  std::vector<ChainContents> chains;  // in order of first appearance
  KindCounts kinds{};
  KindCounts kinds_with_names{};  // atoms whose residue has a name
  std::size_t hydrogens = 0;
  std::size_t with_altloc = 0;  // atoms with the letter of an alternative location
};

// Counts the atoms of all models together.
MoleculeContents contents_of(const Molecule& molecule);

}  // namespace alphascope
