// SPDX-License-Identifier: GPL-3.0-or-later
// Applies treatments, which set kinds of residues by hand.
#include "core/selection/treatments.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/selection/selection_masks.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

constexpr ResidueKind kKinds[] = {ResidueKind::polymer, ResidueKind::ligand, ResidueKind::ion,
                                  ResidueKind::water, ResidueKind::dummy};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// Returns whether the text is no expression but may be a residue name ("PU8"). Another file may
// have such residues.
bool is_only_a_name(std::string_view text) {
  constexpr std::string_view kNoName = " \t:#,()\"'";
  return text.find_first_of(kNoName) == text.npos && fault_of_selection(text).has_value();
}

// If the molecule has residues of this name, finds them by it. Otherwise reads an address or
// expression.
std::function<bool(std::size_t)> residues_named(const Molecule& molecule, const std::string& text) {
  const NameId name = molecule.names.find(text);
  const auto has_name = [&](const Atom& atom) { return atom.residue_name == name; };
  if (name != 0 && std::any_of(molecule.atoms.begin(), molecule.atoms.end(), has_name)) {
    return [&molecule, name](std::size_t i) { return molecule.atoms[i].residue_name == name; };
  }
  if (is_only_a_name(text)) return [](std::size_t) { return false; };
  return atoms_named(molecule, text);
}

using Reasons = std::set<ResidueReason>;

// Removes a note on guesses if none of its residues is a guess any more. Otherwise adds to the note
// that some are set by hand.
void settle_notes(Molecule& molecule, const Reasons& treated_guesses) {
  for (const ResidueReason guess : treated_guesses) {
    const bool is_left = std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                                     [&](const Atom& atom) { return atom.why == guess; });
    const std::string begin = guess_note(guess);
    if (is_left) {
      for (std::string& note : molecule.notes) {
        if (note.starts_with(begin)) note += "; some of them are set by hand now";
      }
    } else {
      std::erase_if(molecule.notes,
                    [&](const std::string& note) { return note.starts_with(begin); });
    }
  }
}

// Applies one treatment. Adds the reasons of treated guesses to `guesses`.
std::vector<bool> apply_treatments(Molecule& molecule, const Treatment& treatment,
                                   Reasons& guesses) {
  const auto named = residues_named(molecule, treatment.residues);
  std::vector<bool> atoms(molecule.atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = named(i);
  atoms = whole_residues(molecule, std::move(atoms));
  bool found = false;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (!atoms[i]) continue;
    found = true;
    Atom& atom = molecule.atoms[i];
    // A point without matter stays a dummy, whatever the kind of its residue.
    if (atom.why == ResidueReason::virtual_site) continue;
    if (is_guess(atom.why)) guesses.insert(atom.why);
    atom.kind = treatment.kind;
    atom.why = ResidueReason::by_hand;
  }
  if (!found) {
    molecule.notes.push_back("Residues to be treated as " + std::string(kind_name(treatment.kind)) +
                             " that are not in this file: " + printable(treatment.residues));
  }
  return atoms;
}

}  // namespace

const char* kind_name(ResidueKind kind) {
  static constexpr const char* kNames[] = {"polymer", "water", "ligand", "ion", "dummy"};
  return kNames[static_cast<std::size_t>(kind)];
}

Treatment parse_treatment(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  const std::string_view residues = without_blanks(text.substr(0, std::min(equals, text.size())));
  if (equals != std::string_view::npos && !residues.empty()) {
    const std::string_view word = without_blanks(text.substr(equals + 1));
    for (const ResidueKind kind : kKinds) {
      if (word != kind_name(kind)) continue;
      const auto fault = is_only_a_name(residues) ? std::nullopt : fault_of_address(residues);
      if (!fault) return {std::string(residues), kind};
      throw std::invalid_argument("\"" + printable(std::string(residues)) +
                                  "\" names no residues, " + fault->what());
    }
  }
  throw std::invalid_argument("\"" + printable(std::string(text)) +
                              "\" does not say what residues are; write them as "
                              "\"A:PU8 301=ligand\" or \"PU8=ligand\", with polymer, ligand, ion, "
                              "water or dummy");
}

std::string treatment_text(const Treatment& treatment) {
  return treatment.residues + "=" + kind_name(treatment.kind);
}

TreatedAtoms apply_treatments(Molecule& molecule, const std::vector<std::string>& treatments) {
  TreatedAtoms atoms;
  Reasons guesses;
  for (const std::string& text : treatments) {
    atoms.push_back(apply_treatments(molecule, parse_treatment(text), guesses));
  }
  settle_notes(molecule, guesses);
  return atoms;
}

void set_treatment(std::vector<std::string>& treatments, const Treatment& treatment) {
  reset_treatment(treatments, treatment.residues);
  treatments.push_back(treatment_text(treatment));
}

void reset_treatment(std::vector<std::string>& treatments, std::string_view residues) {
  std::erase_if(treatments, [&](const std::string& text) {
    const std::size_t equals = text.rfind('=');
    return without_blanks(std::string_view(text).substr(0, std::min(equals, text.size()))) ==
           residues;
  });
}

}  // namespace alphascope
