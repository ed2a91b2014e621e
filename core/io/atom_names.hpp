// Guessing what a name in a coordinate file means: elements from atom names, kinds of residues.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// What is known of a residue by its name alone.
enum class ResidueFamily : std::uint8_t { unknown, biopolymer, ligand, water, ion, dummy };
ResidueFamily residue_family(std::string_view residue_name);

// residue_family() of interned names, each asked once.
class ResidueFamilies {
 public:
  ResidueFamily of(NameId residue_name, const NameTable& names);

 private:
  std::vector<std::optional<ResidueFamily>> families_;  // by NameId
};

// An unknown residue is a ligand when its atoms are HETATM, else part of a polymer; a known ligand
// is one either way, since many programs write ATOM only.
AtomKind atom_kind(ResidueFamily family, bool hetero);

// Element of an atom name without blanks. In a biopolymer "CA" and "HG" are C and H; elsewhere a
// two-letter symbol in front wins ("CA" is calcium). kUnknownElement if it names none.
Element element_from_atom_name(std::string_view name, bool biopolymer);

// "CA", "HG", "NE": one of C H N O P S before a letter that counts positions along a chain.
bool has_position_letter(std::string_view name);

// The first characters of a text, printable, for messages.
std::string shortened(std::string_view text);

}  // namespace alphascope
