// Guessing what a name in a coordinate file means: elements from atom names, kinds of residues.
#pragma once

#include <string>
#include <string_view>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// What is known of a residue by its name alone.
enum class ResidueFamily : std::uint8_t { unknown, biopolymer, water, ion, dummy };
ResidueFamily residue_family(std::string_view residue_name);

// Element of an atom name without blanks. In a biopolymer "CA" and "HG" are C and H; elsewhere a
// two-letter symbol in front wins ("CA" is calcium). kUnknownElement if it names none.
Element element_from_atom_name(std::string_view name, bool biopolymer);

// The first characters of a text, printable, for messages.
std::string shortened(std::string_view text);

}  // namespace alphascope
