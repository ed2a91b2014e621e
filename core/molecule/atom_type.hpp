// SPDX-License-Identifier: GPL-3.0-or-later
// Chemical types of the heavy atoms of proteins and nucleic acids, by residue and atom name.
// United-atom radii sets use them. Hydrogens and ligands have no type.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphascope {

enum class AtomType : std::uint8_t {
  none,
  aliphatic_carbon,    // four bonds
  trigonal_carbon,     // three bonds, no hydrogen: carbonyl, ring junction
  aromatic_ch_carbon,  // three bonds, one hydrogen
  nucleic_sugar_carbon,
  nucleic_base_carbon,
  nucleic_base_ch_carbon,
  nucleic_methyl_carbon,
  amide_nitrogen,  // all nitrogens of proteins but lysine NZ
  amine_nitrogen,  // lysine NZ
  nucleic_nitrogen,
  carbonyl_oxygen,  // one bond
  hydroxyl_oxygen,  // also ether and ester
  sulphur,
  selenium,
  phosphorus,
};

// The standard name: "HIS" for HIS, HID, NHIE (an N-terminus of AMBER) and so on. Empty for an
// unknown amino acid.
std::string_view standard_amino_acid(std::string_view residue);

// One of ACGIUT for a nucleotide; 0 otherwise.
char nucleotide_base(std::string_view residue);

// Names must have no blanks. "O1P", "C5*" and residue names of simulation packages are understood.
AtomType atom_type(std::string_view residue, std::string_view atom);

// Returns whether an oxygen is of the carboxylate of aspartate or glutamate, or is OXT at a chain's
// end. The other oxygen there is called O, as in every residue, and does not count.
bool is_carboxylate_oxygen(std::string_view residue, std::string_view atom);

}  // namespace alphascope
