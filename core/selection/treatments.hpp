// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of residues that a user sets, whatever the file and its evidence say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/residue_kind.hpp"

namespace alphascope {

struct Molecule;

// A treatment such as "A:PU8 301=ligand": an address (core/selection/atom_address.hpp), an
// expression or a residue name, and the kind.
struct Treatment {
  std::string residues;
  ResidueKind kind = ResidueKind::ligand;
};

// "polymer", "water", "ligand", "ion", "dummy".
const char* kind_name(ResidueKind kind);

// Throws std::invalid_argument if the text is no treatment, or if its address or expression cannot
// be understood. Does not look for the residues.
Treatment parse_treatment(std::string_view text);
std::string treatment_text(const Treatment& treatment);

// For each treatment the atoms that it named, one value for each atom.
using TreatedAtoms = std::vector<std::vector<bool>>;

// Sets the kind of all atoms of these residues in the order of the list, with
// ResidueReason::by_hand. Adds a note on each treatment that found nothing. Removes notes on
// guesses of which none is left. Throws as parse_treatment().
TreatedAtoms apply_treatments(Molecule& molecule, const std::vector<std::string>& treatments);

// Both remove the list's treatment of these residues. set_treatment() then adds the new one.
void set_treatment(std::vector<std::string>& treatments, const Treatment& treatment);
void reset_treatment(std::vector<std::string>& treatments, std::string_view residues);

}  // namespace alphascope
