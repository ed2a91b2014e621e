// SPDX-License-Identifier: GPL-3.0-or-later
// Addresses of atoms: "A:HIS 87:NE2" is chain, residue and atom. The program shows them for the
// atom under the mouse and understands them as input.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/selection/picture_atoms.hpp"

namespace alphascope {

class SelectionError;
struct Molecule;

// The address of an atom: "A:HIS 87:NE2", "A-2:SER 22A:CB:B". Its parts are chain, residue name and
// number with insertion code, atom, and the letter of an alternative location. An atom without
// names in the file is "#12", the twelfth atom of the file.
std::string atom_address(const Molecule& molecule, std::size_t atom);
// The address without atom and alternative location: "A:HIS 87".
std::string residue_address(const Molecule& molecule, std::size_t atom);
// The address of the residue without the chain: "HIS 87", "#12".
std::string residue_within_chain(const Molecule& molecule, std::size_t atom);

// A name in double quotes for expressions. A quote in the name (an atom O5") becomes the pattern
// for any character.
std::string quoted_name(std::string_view name);

// Returns which atoms of the molecule, by index, a list of addresses with commas names. A part that
// is left out or * means any. So "A:" is chain A, ":87" is residue 87 of every chain, "::CA" are
// all atoms CA, "A:10-20" is a range, and "#12" are all copies of that atom. A text without ":" in
// which no address begins with "#" is read as an expression of selection_expression.hpp. The
// molecule must outlive the result. Throws SelectionError.
std::function<bool(std::size_t)> atoms_named(const Molecule& molecule, std::string_view text,
                                             const PictureAtoms& picture = {});

// The reason why atoms_named() cannot understand a text, without a picture and for any molecule;
// empty if it can.
std::optional<SelectionError> fault_of_address(std::string_view text);

}  // namespace alphascope
