// SPDX-License-Identifier: GPL-3.0-or-later
// The bonds of a model, with the evidence for each. They decide what is drawn, and nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/molecule/bond.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BondList {
  // Each pair of atoms once. Those of one copy of an assembly come together; within a molecule as
  // deposited they ascend.
  std::vector<Bond> bonds;
  std::array<std::size_t, kBondReasons> reasons{};  // of `bonds`, by BondReason
  std::size_t coordinations = 0;                    // of `bonds`
  // Bonds that the file states or a residue should have, and that are left out.
  std::size_t too_long = 0;      // longer than twice the sum of the covalent radii
  std::size_t other_copies = 0;  // between chains that are not copied together
  std::size_t unresolved = 0;    // to atoms that are not in the file (Molecule::unresolved_bonds)
  std::size_t crowded = 0;       // atoms with too many others at one place; none is guessed there

  std::size_t guessed() const { return reasons[static_cast<std::size_t>(BondReason::distance)]; }
};

// Bonds of one model, in this order of evidence:
//  1. The file's own: CONECT, LINK, SSBOND, struct_conn, the bonds of MOL2. Then chem_comp_bond of
//     mmCIF, for residues that the next rule does not know.
//  2. Known structures of amino acids and nucleotides (residue_structures.hpp).
//  3. C to N and O3' to P of neighbours in a chain, up to 2 Å.
//  4. Distances, for all other atoms: up to the sum of the covalent radii and 0.45 Å within a
//     residue, 0.25 Å more than the sum between residues. Nearer than 0.4 Å there is no bond. The
//     nearest atoms count where an element cannot have so many bonds. Free ends of chains are
//     bonded to each other, and S to S of cysteines. Two atoms of one residue are not, if the file
//     states other bonds of both.
// A hydrogen has one bond, to the nearest heavy atom of its residue. Metals have coordinations to
// N, O, S, Se and halogens, and to nothing else but by the file. Waters and lone ions have bonds to
// metals only. Alternative locations with different letters are never bonded, nor are dummies.
//
// Takes time linear in the atoms, however they lie, and works on the caller's threads. The copies
// of an assembly have the bonds of the first one; bonds between copies are not looked for. Throws
// Cancelled.
BondList find_bonds(const Molecule& molecule, const ModelRange& model,
                    const RunContext& context = {});

// The bonds between balls, with indices of balls in place of atoms. `atom_of_ball` is that of
// PreparedBalls, ascending.
std::vector<Bond> bonds_of_balls(std::span<const Bond> bonds,
                                 std::span<const std::uint32_t> atom_of_ball);

// "337 bonds: 3 from the file, 289 of known residues, 45 between neighbours in a chain; 0 guessed
// by distance". Says also how many were left out.
std::string summary(const BondList& list);

}  // namespace alphascope
