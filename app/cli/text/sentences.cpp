// SPDX-License-Identifier: GPL-3.0-or-later
// Finds balls by address or index, and prints sentences in columns.
#include "app/cli/text/sentences.hpp"

#include <algorithm>
#include <ostream>

#include "app/cli/failure.hpp"
#include "app/cli/text/text.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/selection_error.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_parts.hpp"
#include "core/text/utf8.hpp"

namespace alphascope::cli {

std::string AddressedBalls::note_on_others() const {
  return others ? " Atoms that are left out of the complex have no balls." : "";
}

AddressedBalls balls_by_address(const BallReferences& atoms, const std::string& option,
                                const std::string& text) {
  NamedAtoms named;
  try {
    named = named_atoms(atoms, text);
  } catch (const SelectionError& error) {
    throw UsageError(option + " \"" + text + "\", " + error.what());
  }
  AddressedBalls found{{}, named.others > 0};
  for (const Ref& ref : named.balls) {
    const auto balls = atoms.balls(ref);
    found.balls.insert(found.balls.end(), balls->begin(), balls->end());
  }
  return found;
}

BallIndex ball_by_index(const Input& input, const std::string& option, int index) {
  const std::size_t count = input.prepared().balls->size();
  if (static_cast<std::size_t>(index) < count) return static_cast<BallIndex>(index);
  throw UsageError(option + ": there is no ball " + std::to_string(index) + ": " +
                   printable(input.molecule().source.filename().string()) + " has " +
                   counted(count, "ball", "balls") +
                   (count > 0 ? ", 0 to " + std::to_string(count - 1) + "." : "."));
}

void print_line(std::ostream& out, const ExplanationLine& line) {
  constexpr std::size_t kMargin = 14, kWidth = 82;
  std::string row =
      line.heading + std::string(kMargin - std::min(kMargin, line.heading.size()), ' ');
  std::size_t used = 0;
  for (const std::string& word : words_of(line.text)) {
    if (used > 0 && used + 1 + character_count(word) > kWidth) {
      out << row << "\n";
      row = std::string(kMargin, ' ');
      used = 0;
    }
    row += (used > 0 ? " " : "") + word;
    used += (used > 0 ? 1 : 0) + character_count(word);
  }
  out << row << "\n";
}

}  // namespace alphascope::cli
