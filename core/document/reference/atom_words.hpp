// Lists of a command line that give atoms a word each: "resn HEM=#ff8800; chain A=#888".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/reference/atom_set.hpp"

namespace alphascope {

// Throws std::invalid_argument when no atom is meant, SelectionError for what cannot be read.
AtomSet some_named(const Molecule& molecule, std::string_view expression);

struct AtomWord {
  AtomSet atoms;
  std::string word, part;  // "#ff8800", and all of "resn HEM=#ff8800"
};
// Parts between semicolons, each of atoms, "=" and a word. `what` and `example` are for the
// message of std::invalid_argument: "their colour", "resn HEM=#ff8800".
std::vector<AtomWord> atom_words(const Molecule& molecule, std::string_view text,
                                 const std::string& what, const std::string& example);
// What that throws, for a word that is none.
[[noreturn]] void refuse_atom_word(std::string_view part, const std::string& what,
                                   const std::string& example);

}  // namespace alphascope
