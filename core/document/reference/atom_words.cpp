// SPDX-License-Identifier: GPL-3.0-or-later
// Splits lists such as "resn HEM=#ff8800; chain A=#888", and reports errors in them.
#include "core/document/reference/atom_words.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

AtomSet some_named(const Molecule& molecule, std::string_view expression) {
  AtomSet set = named_set(molecule, expression);
  if (set.empty()) {
    throw std::invalid_argument("no atom matches \"" + std::string(expression) + "\"");
  }
  return set;
}

void refuse_atom_word(std::string_view part, const std::string& what, const std::string& example) {
  throw std::invalid_argument("\"" + std::string(part) + "\" must be atoms, = and " + what +
                              ", such as " + example);
}

std::vector<AtomWord> atom_words(const Molecule& molecule, std::string_view text,
                                 const std::string& what, const std::string& example) {
  std::vector<AtomWord> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view part = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = part.rfind('=');
    const std::string_view atoms = trimmed(part.substr(0, equals));
    if (equals == std::string_view::npos || atoms.empty()) refuse_atom_word(part, what, example);
    words.push_back({some_named(molecule, atoms), std::string(trimmed(part.substr(equals + 1))),
                     std::string(part)});
  }
  return words;
}

}  // namespace alphascope
