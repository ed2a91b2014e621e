// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers the chains and gives them their colours.
#include "core/molecule/chain_colours.hpp"

#include <algorithm>

#include "core/molecule/atom_colours.hpp"
#include "core/molecule/residue_class.hpp"

namespace alphascope {

ChainColours::ChainColours(const Molecule& molecule) : molecule_(molecule) {
  of_chain_.resize(molecule.names.size());
  std::vector<bool> seen(molecule.names.size(), false);
  std::size_t chains = 0;
  for (const Atom& atom : molecule.atoms) {
    polymers_ = polymers_ || atom.kind == ResidueKind::polymer;
    if (seen[atom.chain]) continue;
    seen[atom.chain] = true;
    of_chain_[atom.chain] = chain_colour(chains++);
  }
}

Rgb8 ChainColours::of(const Atom& atom) const {
  if (by_chain(atom)) return of_chain_[atom.chain];
  return residue_class_colour(residue_class(molecule_, atom));
}

std::vector<Rgb8> colours_by_chain(const Molecule& molecule,
                                   const std::vector<std::uint32_t>& atom_of_ball) {
  const ChainColours colour(molecule);
  std::vector<Rgb8> colours;
  colours.reserve(atom_of_ball.size());
  for (const std::uint32_t atom : atom_of_ball) colours.push_back(colour.of(molecule.atoms[atom]));
  return colours;
}

}  // namespace alphascope
