// SPDX-License-Identifier: GPL-3.0-or-later
// Groups balls by atom, residue or chain.
#include "core/selection/atom_groups.hpp"

#include <algorithm>
#include <utility>

#include "core/selection/atom_address.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNew = 0xffffffff;

// The atoms of the current residue. A repeated atom shows that the next residue begins.
class OneResidue {
 public:
  void begin(const Molecule& molecule, const Atom& atom) {
    seen_.clear();
    has_names_ = false;
    add(molecule, atom);
  }

  // Returns whether the atom begins another residue of the same name and number. Waters and ions
  // may all have one number. Other residues with the number 0 may have the same number, too. There
  // a repeated atom name ends a residue, unless the names are only element symbols.
  bool ends_before(const Molecule& molecule, const Atom& atom) {
    const bool alone = atom.kind == ResidueKind::water || atom.kind == ResidueKind::ion;
    const bool told = alone || (atom.residue_number == 0 && has_names_);
    const bool again = told && atom.name != 0 && atom.kind != ResidueKind::ligand && comes(atom);
    if (!again) add(molecule, atom);
    return again;
  }

 private:
  static constexpr std::size_t kMostAtoms = 256;

  void add(const Molecule& molecule, const Atom& atom) {
    if (seen_.size() < kMostAtoms) seen_.push_back({atom.name, atom.altloc});
    has_names_ |= molecule.text(atom.name).size() > element_symbol(atom.element).size();
  }
  // Returns whether the atom is there already. For number 0, an atom with a letter and one without
  // belong to two residues. Two letters may belong to one.
  bool comes(const Atom& atom) const {
    return std::any_of(seen_.begin(), seen_.end(), [&](const auto& seen) {
      return seen.first == atom.name &&
             (seen.second == atom.altloc ||
              (atom.residue_number == 0 && (seen.second == ' ' || atom.altloc == ' ')));
    });
  }

  std::vector<std::pair<NameId, char>> seen_;
  bool has_names_ = false;  // whether an atom's name is longer than its element
};

}  // namespace

bool same_residue(const Atom& a, const Atom& b) {
  const bool named = a.residue_name != 0 || a.residue_number != 0;
  return named && same_residue_number(a, b) && a.residue_name == b.residue_name;
}

AtomGroups atom_groups(const Molecule& molecule, std::span<const std::uint32_t> atom_of_ball,
                       AtomGrouping by) {
  AtomGroups groups;
  groups.of_ball.reserve(atom_of_ball.size());
  std::vector<std::uint32_t> of_chain(molecule.names.size(), kNew);
  const Atom* last = nullptr;
  std::size_t last_index = 0;
  OneResidue residue;
  for (const std::uint32_t index : atom_of_ball) {
    const Atom& atom = molecule.atoms[index];
    const auto next = static_cast<std::uint32_t>(groups.first.size());
    std::uint32_t group = next;
    if (by == AtomGrouping::residue) {
      bool goes_on = last && same_residue(*last, atom);
      if (goes_on) {
        // Atoms in between that are no balls count as well.
        for (std::size_t k = last_index + 1; k <= index; ++k) {
          const Atom& next_atom = molecule.atoms[k];
          if (!same_residue(*last, next_atom) || !residue.ends_before(molecule, next_atom))
            continue;
          residue.begin(molecule, next_atom);
          goes_on = false;
        }
      } else {
        residue.begin(molecule, atom);
      }
      if (goes_on) group = next - 1;
    }
    if (by == AtomGrouping::chain) {
      std::uint32_t& known = of_chain[atom.chain];
      if (known == kNew) known = next;
      group = known;
    }
    if (group == next) groups.first.push_back(index);
    groups.of_ball.push_back(group);
    last = &atom;
    last_index = index;
  }
  return groups;
}

std::string group_name(const Molecule& molecule, std::size_t atom, AtomGrouping by) {
  if (by == AtomGrouping::atom) return atom_address(molecule, atom);
  if (by == AtomGrouping::residue) return residue_address(molecule, atom);
  return std::string(molecule.text(molecule.atoms[atom].chain));
}

}  // namespace alphascope
