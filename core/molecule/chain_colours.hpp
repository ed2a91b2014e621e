// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of atoms by their chain. Beside polymers, ligands, ions and waters have the colours of
// their classes (residue_class.hpp), so that they stand out.
#pragma once

#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

class ChainColours {
 public:
  // Counts the chains of all atoms in their order, so that a chain keeps its colour while another
  // is switched off. The molecule must live longer.
  explicit ChainColours(const Molecule& molecule);
  Rgb8 of(const Atom& atom) const;
  // Whether the chain decides the colour: of polymers, and of all atoms where there is no polymer.
  bool by_chain(const Atom& atom) const { return !polymers_ || atom.kind == ResidueKind::polymer; }

 private:
  const Molecule& molecule_;
  bool polymers_ = false;
  std::vector<Rgb8> of_chain_;  // by the ids of names
};

// One colour for each ball. `atom_of_ball` as in PreparedBalls.
std::vector<Rgb8> colours_by_chain(const Molecule& molecule,
                                   const std::vector<std::uint32_t>& atom_of_ball);

}  // namespace alphascope
