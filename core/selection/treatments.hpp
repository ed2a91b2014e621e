// What a user says that residues are, whatever the file and its evidence say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// "A:PU8 301=ligand": an address (core/selection/atom_address.hpp), an expression or the name of
// residues, and what they are.
struct Treatment {
  std::string residues;
  AtomKind kind = AtomKind::ligand;
};

// "polymer", "water", "ligand", "ion", "dummy".
const char* kind_name(AtomKind kind);

// Throws std::invalid_argument for a text that is none, and for an address or expression that
// cannot be understood; the residues are not looked for.
Treatment parse_treatment(std::string_view text);
std::string treatment_text(const Treatment& treatment);

// For each treatment, which atoms it named.
using TreatedAtoms = std::vector<std::vector<bool>>;

// Gives all atoms of these residues their kind, in this order, with ResidueReason::by_hand. A note
// says which treatment found nothing; notes on guesses that are none any more go. Throws as
// parse_treatment().
TreatedAtoms treat(Molecule& molecule, const std::vector<std::string>& treatments);

// Takes what was said of these residues out of a list, and adds what is said now, if anything.
void set_treatment(std::vector<std::string>& treatments, const Treatment& treatment);
void reset_treatment(std::vector<std::string>& treatments, std::string_view residues);

}  // namespace alphascope
