// SPDX-License-Identifier: GPL-3.0-or-later
// The amino acid residues of a molecule with their backbone atoms, in the order of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/molecule/copy_units.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {

inline constexpr std::uint32_t kNoAtom = 0xffffffff;

// Indices into Molecule::atoms. Of alternative locations it has those of minor_altlocs() that stay.
struct BackboneResidue {
  std::uint32_t first = 0;  // the residue's first atom
  std::uint32_t ca = 0;
  std::uint32_t n = kNoAtom, c = kNoAtom, o = kNoAtom;  // kNoAtom: not in the file
  // The next residue in the list follows in the same chain. Its N is at most kLongestPeptideBond
  // from this C, or where one is missing, its CA at most kLongestStep from this CA.
  bool bound_to_next = false;
  bool ring_at_nitrogen = false;  // proline and its like, whose N has no hydrogen

  bool complete() const { return n != kNoAtom && c != kNoAtom && o != kNoAtom; }
};

// Å, as DSSP has it. A peptide bond is 1.33 Å long; consecutive residues of a gap are further
// apart.
inline constexpr double kLongestPeptideBond = 2.5;
// Å. Consecutive CA are 3.8 Å apart, or 2.9 Å across a cis bond.
inline constexpr double kLongestStep = 4.3;

// The residues of the first copy of a unit. Residues of a polymer with CA count, whatever their
// names. A residue begins where chain, number or insertion code change, or where the name of a
// backbone atom comes again.
std::vector<BackboneResidue> find_backbone(const Molecule& molecule, const CopyUnit& unit);

// Sets bound_to_next of residues in their order.
void find_chain_breaks(const Molecule& molecule, std::vector<BackboneResidue>& residues);

// Å
inline RealPoint position_angstrom(const Molecule& molecule, std::uint32_t atom) {
  return molecule.lattice.unit_angstrom() * real_point(molecule.atoms[atom].position);
}

}  // namespace alphascope
