// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a molecule's residues by name and decision, from which people choose what to set by
// hand. A treatment is a text that names residues and sets their kind; a group has texts for its
// residues.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/molecule/residue_reason.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/treatments.hpp"

namespace alphascope {

struct Molecule;

// Residues of one name with the same kind and reason, both in the file and now.
struct ResidueGroup {
  std::string name;  // empty: the file gives none
  ResidueKind kind = ResidueKind::polymer;
  ResidueReason why = ResidueReason::none;       // `by_hand` if a treatment decided
  ResidueKind file_kind = ResidueKind::polymer;  // without treatments
  ResidueReason file_why = ResidueReason::none;
  std::size_t residues = 0, atoms = 0;
  std::size_t nth = 1;  // number among the groups of this name, in the order of the list
  // The texts by which treatments name these residues. If no other group has their name, it is the
  // name. Otherwise it is the address of each, or an expression that excludes the others. Empty if
  // they cannot be named: points without matter, atoms that have nothing but a chain, and groups in
  // which both these residues and the others of the name are more than kMostAddresses.
  std::vector<std::string> called;
  std::vector<std::string> treated;  // treatments in use that name any of these residues
  friend bool operator==(const ResidueGroup&, const ResidueGroup&) = default;
};

struct ResidueGroups {
  // First the guesses of the file's reader, then ligands, ions, dummies, waters and polymers, each
  // by name. Treatments do not change the order.
  std::vector<ResidueGroup> of;
  KindCounts kinds{};       // numbers of residues; points without matter do not count
  std::size_t guessed = 0;  // residues that are still a guess
  std::size_t by_hand = 0;
};

inline constexpr std::size_t kMostAddresses = 50;

// Groups the atoms [begin, end) of `molecule`. It was made from `deposited` by assembly and
// treatments. `treated` belongs to `treatments`. Returns no groups if the format has no residues.
ResidueGroups residue_groups(const Molecule& deposited, const Molecule& molecule, std::size_t begin,
                             std::size_t end, const std::vector<std::string>& treatments,
                             const TreatedAtoms& treated);

// A summary: "2 guessed, 1 set by hand"; if there are none, "polymer 46 · water 58".
std::string decisions_text(const ResidueGroups& groups);

// The reason for people: "a polymer in the entity table". For residues set by hand: "set by hand;
// otherwise ligand (HETATM, and no part of a chain)".
std::string why_text(const ResidueGroup& group);

// An expression or addresses that select the residues; empty if `called` is.
std::string selection_text(const ResidueGroup& group);

// set_group_kind() sets the kind of the residues. remove_treatments() removes every treatment that
// names any of them.
void set_group_kind(std::vector<std::string>& treatments, const ResidueGroup& group,
                    ResidueKind kind);
void remove_treatments(std::vector<std::string>& treatments, const ResidueGroup& group);

}  // namespace alphascope
