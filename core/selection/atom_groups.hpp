// Balls by the atom, residue or chain that they belong to.
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
  std::vector<std::uint32_t> first;  // atom of the first ball of each
  std::size_t size() const { return first.size(); }
};

// Whether two neighbours in a file are of one residue. Atoms without any names are residues of
// their own.
bool same_residue(const Atom& a, const Atom& b);

// `atom_of_ball` as in PreparedBalls. A residue ends where the next atom is of another one: atoms
// that share an address, as in files that run out of numbers, are one residue only when they are
// neighbours. Where neighbours share it too, the next residue begins with the atom that comes
// again. A chain has all atoms of its name.
AtomGroups atom_groups(const Molecule& molecule, std::span<const std::uint32_t> atom_of_ball,
                       AtomGrouping by);

// "A:HIS 87:NE2", "A:HIS 87", "A": of the group of an atom.
std::string group_name(const Molecule& molecule, std::size_t atom, AtomGrouping by);

}  // namespace alphascope
