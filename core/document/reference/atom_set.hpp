// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of atoms of a file and its copies in an assembly, as runs. They are small for chains and
// residues, which are mostly hidden or coloured as a whole. So each entry of the history can keep
// one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace alphascope {

class BallReferences;
struct AtomRef;
struct Molecule;
struct PictureAtoms;

class AtomSet {
 public:
  // Atoms `first` to `last` of one copy, numbered as in AtomRef.
  struct Run {
    std::uint32_t copy = 0, first = 0, last = 0;
    friend auto operator<=>(const Run&, const Run&) = default;
  };

  AtomSet() = default;
  explicit AtomSet(std::vector<Run> runs);  // in any order; may overlap

  const std::vector<Run>& runs() const;  // ascending, with gaps between them
  bool empty() const { return runs().empty(); }
  std::uint64_t size() const;  // number of atoms
  bool contains(const AtomRef& atom) const;

  AtomSet with(const AtomSet& other) const;
  AtomSet without(const AtomSet& other) const;

  friend bool operator==(const AtomSet& a, const AtomSet& b) {
    return a.runs_ == b.runs_ || a.runs() == b.runs();
  }

 private:
  std::shared_ptr<const std::vector<Run>> runs_;  // null: none
};

// Convert between a value for each atom of the molecule and a set. Atoms that this molecule lacks,
// since it is another assembly, are ignored.
AtomSet atom_set(const Molecule& molecule, const std::vector<bool>& atoms);
std::vector<bool> atoms_of(const Molecule& molecule, const AtomSet& set);

AtomSet all_atoms(const Molecule& molecule);
// Atoms named by an address or an expression (core/selection/atom_address.hpp); may be empty.
// Throws SelectionError.
AtomSet named_set(const Molecule& molecule, std::string_view text, const PictureAtoms& picture);
AtomSet named_set(const Molecule& molecule, std::string_view text);  // for an empty picture

// Sets the value of these atoms in groups of atoms with equal values, such as colours. Without
// `value` they leave their groups. An atom is in at most one group, and no group is empty.
template <class Group, class Value>
void set_value_of_atoms(std::vector<Group>& groups, Value Group::*member, const AtomSet& atoms,
                        const std::optional<Value>& value) {
  for (Group& group : groups) group.atoms = group.atoms.without(atoms);
  if (value && !atoms.empty()) {
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const Group& g) { return g.*member == *value; });
    Group& group = same == groups.end() ? groups.emplace_back() : *same;
    group.*member = *value;
    group.atoms = group.atoms.with(atoms);
  }
  std::erase_if(groups, [](const Group& group) { return group.atoms.empty(); });
}

}  // namespace alphascope
