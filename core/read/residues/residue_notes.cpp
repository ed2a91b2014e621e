// SPDX-License-Identifier: GPL-3.0-or-later
// Counts guesses and contradictions, and turns them into notes.
#include "core/read/residues/residue_notes.hpp"

#include "core/selection/atom_address.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kExamples = 3;

std::string residues_text(std::size_t count) {
  return counted(count, "residue", "residues");
}

}  // namespace

void ResidueNotes::add(Counted& counted, std::size_t first_atom) const {
  if (counted.count < kExamples) {
    counted.examples += (counted.count ? ", " : "") + residue_address(molecule_, first_atom);
  } else if (counted.count == kExamples) {
    counted.examples += " …";
  }
  ++counted.count;
}

void ResidueNotes::guessed(ResidueReason why, std::size_t first_atom) {
  add(guesses_[why], first_atom);
}

void ResidueNotes::disagrees(const char* table_says, ResidueKind kind, std::size_t first_atom) {
  add(disagreements_[{table_says, kind}], first_atom);
}

void ResidueNotes::no_water(std::size_t first_atom) {
  add(no_waters_, first_atom);
}

void ResidueNotes::finish() const {
  for (const auto& [why, counted] : guesses_) {
    molecule_.notes.push_back(std::string(guess_note(why)) + ": " + residues_text(counted.count) +
                              " (" + counted.examples + ")");
  }
  for (const auto& [key, counted] : disagreements_) {
    molecule_.notes.push_back("The entity table says " + key.first +
                              ", but by their own atoms they are " +
                              (key.second == ResidueKind::ion ? "ions" : "water") + ": " +
                              residues_text(counted.count) + " (" + counted.examples + ")");
  }
  if (no_waters_.count > 0) {
    molecule_.notes.push_back(
        "Residues named as water have other atoms, so they are not taken as water: " +
        residues_text(no_waters_.count) + " (" + no_waters_.examples + ")");
  }
}

}  // namespace alphascope
