// SPDX-License-Identifier: GPL-3.0-or-later
// Names of atoms, and the way from copies to deposited atoms and back.
#include "core/molecule/molecule.hpp"

#include <algorithm>

namespace alphascope {
namespace {

// The position of `deposited` in the list; its size if it is not there.
std::size_t place_in(const CopiedAtoms& part, std::size_t deposited) {
  const auto at = std::lower_bound(part.source.begin(), part.source.end(), deposited);
  const bool there = at != part.source.end() && *at == deposited;
  return there ? static_cast<std::size_t>(at - part.source.begin()) : part.source.size();
}

}  // namespace

std::string atom_label(const Molecule& molecule, std::size_t index) {
  const Atom& atom = molecule.atoms[index];
  std::string label(molecule.text(atom.name));
  if (label.empty()) label = "atom " + std::to_string(index + 1);
  if (atom.altloc != ' ') label += std::string(" (") + atom.altloc + ")";
  if (atom.residue_name != 0 || atom.residue_number != 0) {
    label += ' ';
    label += molecule.text(atom.residue_name);
    label += ' ' + std::to_string(atom.residue_number);
    if (atom.insertion_code != ' ') label += atom.insertion_code;
  }
  if (atom.chain != 0) {
    label += ", chain ";
    label += molecule.text(atom.chain);
  }
  return label;
}

AtomSource atom_source(const Molecule& molecule, std::size_t atom) {
  if (molecule.copied.empty()) return {atom, 0};
  const auto next =
      std::upper_bound(molecule.copied.begin(), molecule.copied.end(), atom,
                       [](std::size_t a, const CopiedAtoms& part) { return a < part.begin; });
  const CopiedAtoms& part = *(next - 1);  // the first begins at 0
  const std::size_t inside = atom - part.begin;
  AtomSource source{part.source[inside % part.source.size()], inside / part.source.size()};
  // Copies of the same chain by earlier generators are counted too.
  for (const CopiedAtoms& earlier : molecule.copied) {
    if (earlier.begin == part.begin) break;
    if (place_in(earlier, source.deposited) < earlier.source.size()) source.copy += earlier.copies;
  }
  return source;
}

std::optional<std::size_t> find_atom(const Molecule& molecule, const AtomSource& source) {
  if (molecule.copied.empty()) {
    const bool there = source.copy == 0 && source.deposited < molecule.atoms.size();
    return there ? std::optional(source.deposited) : std::nullopt;
  }
  std::size_t copy = source.copy;
  for (const CopiedAtoms& part : molecule.copied) {
    const std::size_t place = place_in(part, source.deposited);
    if (place == part.source.size()) continue;
    if (copy < part.copies) return part.begin + copy * part.source.size() + place;
    copy -= part.copies;
  }
  return std::nullopt;
}

}  // namespace alphascope
