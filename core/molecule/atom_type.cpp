// SPDX-License-Identifier: GPL-3.0-or-later
// Derives the chemical type of an atom from the names of its residue and itself.
#include "core/molecule/atom_type.hpp"

#include <algorithm>
#include <string>

namespace alphascope {
namespace {

// The trigonal side-chain carbons of an amino acid, without and with hydrogen. All its other
// side-chain carbons are aliphatic.
struct AminoAcid {
  std::string_view name;
  std::string_view trigonal;  // between blanks: " CG CZ "
  std::string_view aromatic_ch;
};

constexpr AminoAcid kAminoAcids[] = {
    {"ALA", "", ""},
    {"ARG", " CZ ", ""},
    {"ASN", " CG ", ""},
    {"ASP", " CG ", ""},
    {"CYS", "", ""},
    {"GLN", " CD ", ""},
    {"GLU", " CD ", ""},
    {"GLY", "", ""},
    {"HIS", " CG ", " CD2 CE1 "},
    {"ILE", "", ""},
    {"LEU", "", ""},
    {"LYS", "", ""},
    {"MET", "", ""},
    {"MSE", "", ""},
    {"PHE", " CG ", " CD1 CD2 CE1 CE2 CZ "},
    {"PRO", "", ""},
    {"SEC", "", ""},
    {"SER", "", ""},
    {"THR", "", ""},
    {"TRP", " CG CD2 CE2 ", " CD1 CE3 CZ2 CZ3 CH2 "},
    {"TYR", " CG CZ ", " CD1 CD2 CE1 CE2 "},
    {"VAL", "", ""},
};

constexpr std::string_view kAliases[][2] = {
    {"HID", "HIS"}, {"HIE", "HIS"}, {"HIP", "HIS"},  {"HSD", "HIS"}, {"HSE", "HIS"},
    {"HSP", "HIS"}, {"CYX", "CYS"}, {"CYM", "CYS"},  {"ASH", "ASP"}, {"GLH", "GLU"},
    {"LYN", "LYS"}, {"ARN", "ARG"}, {"ASPP", "ASP"}, {"GLUP", "GLU"}};

bool in_list(std::string_view list, std::string_view name) {
  const std::size_t at = list.find(name);
  return at != std::string_view::npos && at > 0 && list[at - 1] == ' ' &&
         list[at + name.size()] == ' ';
}

const AminoAcid* find_amino_acid(std::string_view residue) {
  // AMBER gives residues at the ends of a chain a prefix N or C.
  const bool at_end = residue.size() == 4 && (residue[0] == 'N' || residue[0] == 'C');
  if (at_end) residue.remove_prefix(1);
  for (const auto& alias : kAliases) {
    if (alias[0] == residue) residue = alias[1];
  }
  const auto* found = std::find_if(std::begin(kAminoAcids), std::end(kAminoAcids),
                                   [&](const AminoAcid& a) { return a.name == residue; });
  return found == std::end(kAminoAcids) ? nullptr : found;
}

AtomType amino_acid_atom(const AminoAcid& residue, std::string_view atom) {
  switch (atom[0]) {
    case 'C':
      if (atom == "C" || in_list(residue.trigonal, atom)) return AtomType::trigonal_carbon;
      if (in_list(residue.aromatic_ch, atom)) return AtomType::aromatic_ch_carbon;
      return AtomType::aliphatic_carbon;
    case 'N':
      return atom == "NZ" ? AtomType::amine_nitrogen : AtomType::amide_nitrogen;
    case 'O': {
      // Tsai et al. type one oxygen of a carboxyl group as carbonyl and the other as hydroxyl.
      const bool carbonyl = atom == "O" || atom == "OD1" || atom == "OE1" || atom == "OT1";
      return carbonyl ? AtomType::carbonyl_oxygen : AtomType::hydroxyl_oxygen;
    }
    case 'S':
      return atom == "SE" ? AtomType::selenium : AtomType::sulphur;
    default:
      return AtomType::none;
  }
}

AtomType nucleotide_atom(char base, std::string_view atom) {
  const bool sugar = atom.back() == '\'' || atom.back() == '*';
  switch (atom[0]) {
    case 'C': {
      if (sugar) return AtomType::nucleic_sugar_carbon;
      if (atom == "C7" || atom == "C5M") return AtomType::nucleic_methyl_carbon;
      const bool pyrimidine_ch =
          (base == 'C' || base == 'U') ? atom == "C5" || atom == "C6" : base == 'T' && atom == "C6";
      const bool purine_ch = atom == "C8" || (atom == "C2" && (base == 'A' || base == 'I'));
      return pyrimidine_ch || purine_ch ? AtomType::nucleic_base_ch_carbon
                                        : AtomType::nucleic_base_carbon;
    }
    case 'N':
      return AtomType::nucleic_nitrogen;
    case 'O': {
      const bool carbonyl =
          atom == "OP1" || atom == "O1P" || atom == "O2" || atom == "O4" || atom == "O6";
      return carbonyl ? AtomType::carbonyl_oxygen : AtomType::hydroxyl_oxygen;
    }
    case 'P':
      return AtomType::phosphorus;
    default:
      return AtomType::none;
  }
}

}  // namespace

std::string_view standard_amino_acid(std::string_view residue) {
  const AminoAcid* found = find_amino_acid(residue);
  return found ? found->name : std::string_view();
}

char nucleotide_base(std::string_view residue) {
  constexpr std::string_view kLong[][2] = {
      {"ADE", "A"}, {"CYT", "C"}, {"GUA", "G"}, {"THY", "T"}, {"URA", "U"}};
  for (const auto& name : kLong) {
    if (name[0] == residue) return name[1][0];
  }
  if (residue.size() == 3 && (residue[2] == '3' || residue[2] == '5')) residue.remove_suffix(1);
  if (residue.size() == 2 && (residue[0] == 'D' || residue[0] == 'R')) residue.remove_prefix(1);
  if (residue.size() == 2 && (residue[1] == '3' || residue[1] == '5')) residue.remove_suffix(1);
  return residue.size() == 1 && std::string_view("ACGIUT").find(residue) != std::string_view::npos
             ? residue[0]
             : '\0';
}

bool is_carboxylate_oxygen(std::string_view residue, std::string_view atom) {
  const std::string_view name = standard_amino_acid(residue);
  if (name.empty()) return false;
  if (atom == "OXT" || atom == "OT2") return true;
  return (name == "ASP" && (atom == "OD1" || atom == "OD2")) ||
         (name == "GLU" && (atom == "OE1" || atom == "OE2"));
}

AtomType atom_type(std::string_view residue, std::string_view atom) {
  if (atom.empty()) return AtomType::none;
  if (const AminoAcid* amino_acid = find_amino_acid(residue)) {
    return amino_acid_atom(*amino_acid, atom);
  }
  if (const char base = nucleotide_base(residue)) return nucleotide_atom(base, atom);
  if (residue == "HOH" || residue == "WAT") {
    return atom[0] == 'O' ? AtomType::hydroxyl_oxygen : AtomType::none;
  }
  return AtomType::none;
}

}  // namespace alphascope
