// SPDX-License-Identifier: GPL-3.0-or-later
// The steps in which the bonds of one unit (copy_units.hpp) are found. bonds.hpp has the rules.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/molecule/bond.hpp"
#include "core/molecule/copy_units.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// What may be bonded to an atom by distance.
enum class Openness : std::uint8_t {
  none,        // a dummy, or an atom of unknown element
  closed,      // a known residue has all its bonds but those to ligands and metals
  only_metal,  // water and lone ions: metals
  chain_end,   // C, N, P or O3' without a neighbour: other ends as well
  cysteine,    // SG: another one as well
  hydrogen,    // the nearest heavy atom of its residue
  open         // all others
};

// State of one unit, passed from step to step. Atoms are numbered from 0 in the unit.
struct UnitBonds {
  const Molecule& molecule;
  const CopyUnit& unit;
  std::vector<std::uint32_t> atoms = {};    // indices of the first copy, ascending
  std::vector<std::uint32_t> residue = {};  // per atom; kNoResidue for atoms without names
  std::vector<Openness> openness = {};      // per atom
  std::vector<bool> stated = {};            // per atom: the file states a covalent bond of it
  std::vector<Bond> bonds = {};             // with numbers in the unit
  std::size_t too_long = 0, crowded = 0;

  static constexpr std::uint32_t kNoResidue = 0xffffffff;
  const Atom& atom(std::uint32_t number) const { return molecule.atoms[atoms[number]]; }
  double distance_angstrom(std::uint32_t a, std::uint32_t b) const;
  // Adds a bond that the file states or a residue has, if it is not too long.
  void add_known(std::uint32_t a, std::uint32_t b, BondOrder order, BondReason why);
};

// Adds bonds of known residues and between neighbours in chains; sets `residue` and `openness`.
void add_residue_bonds(UnitBonds& state, const RunContext& context);
// Adds bonds by distance to atoms that are open.
void add_distance_bonds(UnitBonds& state, const RunContext& context);

}  // namespace alphascope
