// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the atoms that records of bonds mean, by their names or by their serial numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/read/residues/recorded_bonds.hpp"
#include "core/read/residues/residue_table.hpp"

namespace alphascope {

// Chain, residue number, insertion code and name. Alternative locations of an atom share it.
using AtomKey = std::tuple<NameId, std::int32_t, char, NameId>;

AtomKey atom_key(const Atom& atom);
// Empty if no atom of the file has this name, or none this chain.
std::optional<AtomKey> atom_key(const NameTable& names, const BondedAtom& atom);

// The atoms of a model by their serial numbers.
class AtomsBySerial {
 public:
  AtomsBySerial(const Molecule& molecule, const ModelRange& model);
  // kNoIndex if no atom has this number, or several do: it identifies none of them then.
  std::uint32_t atom(std::int32_t serial) const;

 private:
  std::vector<std::pair<std::int32_t, std::uint32_t>> atoms_;  // sorted
};

}  // namespace alphascope
