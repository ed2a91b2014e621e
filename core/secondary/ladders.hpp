// SPDX-License-Identifier: GPL-3.0-or-later
// Bridges between residues, and the ladders that consecutive bridges form.
#pragma once

#include <vector>

#include "core/secondary/backbone.hpp"
#include "core/secondary/hydrogen_bonds.hpp"

namespace alphascope {

// Two stretches of residues [i_first, i_last] and [j_first, j_last] that lie side by side, with at
// most four residues in a bulge of one and one in that of the other.
struct Ladder {
  bool parallel = false;
  int i_first = 0, i_last = 0, j_first = 0, j_last = 0;
  int bridges = 1;
};

// `chain_of` is the number of breaks of the chain before each residue.
std::vector<Ladder> find_ladders(const std::vector<HydrogenBonds>& bonds,
                                 const std::vector<int>& chain_of);

}  // namespace alphascope
