// SPDX-License-Identifier: GPL-3.0-or-later
// Looks up names in the molecule's table, and serial numbers in a sorted list.
#include "core/read/residues/recorded_atoms.hpp"

#include <algorithm>
#include <string>

#include "core/molecule/name_table.hpp"

namespace alphascope {

AtomKey atom_key(const Atom& atom) {
  return {atom.chain, atom.residue_number, atom.insertion_code, atom.name};
}

std::optional<AtomKey> atom_key(const NameTable& names, const BondedAtom& atom) {
  // Names that no atom has must not count as the empty name, whose id find() returns for them.
  const auto is_there = [&](const std::string& name) {
    return name.empty() || names.find(name) != 0;
  };
  if (!is_there(atom.chain) || !is_there(atom.name)) return std::nullopt;
  return AtomKey{names.find(atom.chain), atom.residue_number, atom.insertion_code,
                 names.find(atom.name)};
}

AtomsBySerial::AtomsBySerial(const Molecule& molecule, const ModelRange& model) {
  atoms_.reserve(model.size());
  for (std::size_t i = model.begin; i < model.end; ++i) {
    atoms_.emplace_back(molecule.atoms[i].serial, static_cast<std::uint32_t>(i));
  }
  std::sort(atoms_.begin(), atoms_.end());
}

std::uint32_t AtomsBySerial::atom(std::int32_t serial) const {
  const auto at = std::lower_bound(atoms_.begin(), atoms_.end(), std::pair(serial, 0u));
  const bool one = at != atoms_.end() && at->first == serial &&
                   (at + 1 == atoms_.end() || (at + 1)->first != serial);
  return one ? at->second : kNoIndex;
}

}  // namespace alphascope
