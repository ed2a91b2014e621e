// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of a molecule's residues with their kinds and reasons, for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class ResidueListing : unsigned char {
  grouped,  // one line for a chain's polymer, one for its waters, one for many residues of one name
  each      // one line for each residue
};

struct ListedResidues {
  std::string chain, name, number;  // "16-223"; `name` is empty if there are several
  ResidueKind kind = ResidueKind::polymer;
  ResidueReason why = ResidueReason::none;
  std::size_t residues = 0, atoms = 0;
  std::size_t first_atom = 0;  // first atom of the first residue
};

// Lists the residues of the atoms [begin, end) in order of appearance. A residue whose atoms differ
// in kind or reason (an ion, a site without matter) has one entry for each.
std::vector<ListedResidues> list_residues(const Molecule& molecule, std::size_t begin,
                                          std::size_t end, ResidueListing listing);

}  // namespace alphascope
