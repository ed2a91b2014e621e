// Chemical types of the heavy atoms of proteins and nucleic acids, by residue and atom name, as the
// united-atom radii sets distinguish them. Hydrogens and ligands have none.
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
  amide_nitrogen,  // and every other nitrogen of proteins but the next
  amine_nitrogen,  // lysine NZ
  nucleic_nitrogen,
  carbonyl_oxygen,  // one bond
  hydroxyl_oxygen,  // and ether, ester
  sulphur,
  selenium,
  phosphorus,
};

// "HIS" for HIS, HID, NHIE (an N-terminus of AMBER) …; empty when it is no known amino acid.
std::string_view standard_amino_acid(std::string_view residue);

// One of ACGIUT for the nucleotides, 0 for everything else.
char nucleotide_base(std::string_view residue);

// Names without blanks; "O1P", "C5*" and residue names of simulation packages are understood.
AtomType atom_type(std::string_view residue, std::string_view atom);

// Of aspartate, glutamate, and the second one at the end of a chain (OXT). The first one there is
// called O, as in every other residue.
bool is_carboxylate_oxygen(std::string_view residue, std::string_view atom);

}  // namespace alphascope
