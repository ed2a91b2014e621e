// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of a command line that give a word to each group of atoms: "resn HEM=#ff8800; chain
// A=#888".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/reference/atom_set.hpp"

namespace alphascope {

// The atoms of an expression. Throws std::invalid_argument if there are none, and SelectionError if
// it cannot be read.
AtomSet some_named(const Molecule& molecule, std::string_view expression);

struct AtomWord {
  AtomSet atoms;
  std::string word, part;  // "#ff8800", and the whole part "resn HEM=#ff8800"
};
// Splits the text at semicolons; each part is atoms, "=" and a word. `what` and `example` are used
// in the message of std::invalid_argument: "their colour", "resn HEM=#ff8800".
std::vector<AtomWord> atom_words(const Molecule& molecule, std::string_view text,
                                 const std::string& what, const std::string& example);
// Throws that exception for an invalid word.
[[noreturn]] void refuse_atom_word(std::string_view part, const std::string& what,
                                   const std::string& example);

}  // namespace alphascope
