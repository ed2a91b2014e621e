// Atoms as people write them: "A:HIS 87:NE2" is chain, residue and atom. What the program says of
// an atom under the mouse can be typed to select it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/molecule/molecule.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {

// "A:HIS 87:NE2", "A-2:SER 22A:CB:B": chain, residue name and number with insertion code, atom, and
// the letter of an alternative location. "#12" is the twelfth atom of the file, for an atom to
// which the file gives no names.
std::string atom_address(const Molecule& molecule, std::size_t atom);
// The same without atom and alternative location: "A:HIS 87".
std::string residue_address(const Molecule& molecule, std::size_t atom);
// The same without the chain: "HIS 87", "#12".
std::string residue_within_chain(const Molecule& molecule, std::size_t atom);

// A name in double quotes, for expressions; one that contains a quote (an atom O5") has the pattern
// for any character in its place.
std::string quoted_name(std::string_view name);

// Which atoms of the molecule, by index, are named by addresses with commas between them. A part
// that is left out or * means any, and so do parts that are missing at the end: "A:" is chain A,
// ":87" is residue 87 of every chain, "::CA" are all atoms CA, "A:10-20" is a range. "#12" finds
// all copies of that atom. A text without ":" in which nothing begins with "#" is an expression of
// selection_expression.hpp. The molecule must outlive the result. Throws SelectionError.
std::function<bool(std::size_t)> atoms_named(const Molecule& molecule, std::string_view text,
                                             const PictureAtoms& picture = {});

// Why atoms_named() cannot understand a text where there is no picture, whatever the molecule;
// nothing when it can.
std::optional<SelectionError> fault_of_address(std::string_view text);

}  // namespace alphascope
