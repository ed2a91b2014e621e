// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of balls: by atom, residue or chain.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class AtomGrouping : std::uint8_t { atom, residue, chain };

// Groups are numbered in the order of their first balls.
struct AtomGroups {
  std::vector<std::uint32_t> of_ball;
  std::vector<std::uint32_t> first;  // for each group the atom of its first ball
  std::size_t size() const { return first.size(); }
};

// Returns whether two neighbours in a file belong to one residue. An atom without any names is a
// residue of its own.
bool same_residue(const Atom& a, const Atom& b);

// Groups the balls; `atom_of_ball` as in PreparedBalls. A residue ends where the next atom is of
// another one. Atoms may share an address, as in files that run out of numbers. They then form one
// residue only if they are neighbours. If neighbours share it too, the next residue begins with the
// first atom that is repeated. A chain has all atoms of its name.
AtomGroups atom_groups(const Molecule& molecule, std::span<const std::uint32_t> atom_of_ball,
                       AtomGrouping by);

// The name of an atom's group: "A:HIS 87:NE2", "A:HIS 87" or "A".
std::string group_name(const Molecule& molecule, std::size_t atom, AtomGrouping by);

}  // namespace alphascope
