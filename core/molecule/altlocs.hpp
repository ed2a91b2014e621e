// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of one of several alternative locations of a residue's atoms.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// Returns for the atoms [begin, end) whether an atom gives way to another location. One letter is
// chosen per residue: highest mean occupancy, then lowest mean B factor, then the first letter. An
// atom without that letter keeps its own best one. If it belongs to another residue type
// (microheterogeneity), it goes with its letter.
//
// Residues that share chain and number are told apart in three ways. They have different segments,
// numbers begin anew between them (10,000 waters in four columns), or both have the same atom.
//
// Only atoms for which `compete` returns true take part; without `compete` all do. So a selection
// of letter B keeps location B, and a selection without A keeps one of the other locations.
std::vector<bool> minor_altlocs(const Molecule& molecule, std::size_t begin, std::size_t end,
                                const std::function<bool(const Atom&)>& compete = {});

}  // namespace alphascope
