// SPDX-License-Identifier: GPL-3.0-or-later
// The table of residues, and names of atoms in other programs.
#include "core/bonds/residue_structures.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "core/molecule/atom_type.hpp"

namespace alphascope {
namespace {

// Bonds between blanks. Orders: "-" single, "=" double, "~" aromatic.
struct Entry {
  std::string_view residue, bonds;
};

constexpr std::string_view kAminoAcid = "N-CA CA-C C=O C-OXT";
constexpr Entry kAminoAcids[] = {
    {"ALA", "CA-CB"},
    {"ARG", "CA-CB CB-CG CG-CD CD-NE NE-CZ CZ-NH1 CZ=NH2"},
    {"ASN", "CA-CB CB-CG CG=OD1 CG-ND2"},
    {"ASP", "CA-CB CB-CG CG=OD1 CG-OD2"},
    {"CYS", "CA-CB CB-SG"},
    {"GLN", "CA-CB CB-CG CG-CD CD=OE1 CD-NE2"},
    {"GLU", "CA-CB CB-CG CG-CD CD=OE1 CD-OE2"},
    {"GLY", ""},
    {"HIS", "CA-CB CB-CG CG~ND1 CG~CD2 ND1~CE1 CD2~NE2 CE1~NE2"},
    {"ILE", "CA-CB CB-CG1 CB-CG2 CG1-CD1"},
    {"LEU", "CA-CB CB-CG CG-CD1 CG-CD2"},
    {"LYS", "CA-CB CB-CG CG-CD CD-CE CE-NZ"},
    {"MET", "CA-CB CB-CG CG-SD SD-CE"},
    {"MSE", "CA-CB CB-CG CG-SE SE-CE"},
    {"PHE", "CA-CB CB-CG CG~CD1 CG~CD2 CD1~CE1 CD2~CE2 CE1~CZ CE2~CZ"},
    {"PRO", "CA-CB CB-CG CG-CD CD-N"},
    {"SEC", "CA-CB CB-SE"},
    {"SER", "CA-CB CB-OG"},
    {"THR", "CA-CB CB-OG1 CB-CG2"},
    {"TRP",
     "CA-CB CB-CG CG~CD1 CG~CD2 CD1~NE1 NE1~CE2 CD2~CE2 CD2~CE3 CE2~CZ2 CE3~CZ3 CZ2~CH2 CZ3~CH2"},
    {"TYR", "CA-CB CB-CG CG~CD1 CG~CD2 CD1~CE1 CD2~CE2 CE1~CZ CE2~CZ CZ-OH"},
    {"VAL", "CA-CB CB-CG1 CB-CG2"},
};

// DNA has no O2'; atoms that a residue lacks have no bonds.
constexpr std::string_view kNucleotide =
    "P=OP1 P-OP2 P-OP3 P-O5' O5'-C5' C5'-C4' C4'-O4' C4'-C3' C3'-O3' C3'-C2' C2'-O2' C2'-C1' "
    "C1'-O4'";
constexpr Entry kNucleotides[] = {
    {"A", "C1'-N9 N9~C8 C8~N7 N7~C5 C5~C6 C6-N6 C6~N1 N1~C2 C2~N3 N3~C4 C4~C5 C4~N9"},
    {"C", "C1'-N1 N1-C2 C2=O2 C2-N3 N3=C4 C4-N4 C4-C5 C5=C6 C6-N1"},
    {"G", "C1'-N9 N9~C8 C8~N7 N7~C5 C5~C4 C4~N9 C5-C6 C6=O6 C6-N1 N1-C2 C2-N2 C2=N3 N3-C4"},
    {"I", "C1'-N9 N9~C8 C8~N7 N7~C5 C5~C4 C4~N9 C5-C6 C6=O6 C6-N1 N1-C2 C2=N3 N3-C4"},
    {"T", "C1'-N1 N1-C2 C2=O2 C2-N3 N3-C4 C4=O4 C4-C5 C5=C6 C6-N1 C5-C7"},
    {"U", "C1'-N1 N1-C2 C2=O2 C2-N3 N3-C4 C4=O4 C4-C5 C5=C6 C6-N1"},
};

// The last two rows are of GROMOS and CHARMM.
constexpr std::string_view kAminoAcidNames[][2] = {{"OT1", "O"},   {"OC1", "O"},   {"O1", "O"},
                                                   {"OT2", "OXT"}, {"OC2", "OXT"}, {"O2", "OXT"}};
constexpr std::string_view kNucleotideNames[][2] = {
    {"O1P", "OP1"}, {"O2P", "OP2"}, {"O3P", "OP3"}, {"C5M", "C7"},  {"C1*", "C1'"},
    {"C2*", "C2'"}, {"C3*", "C3'"}, {"C4*", "C4'"}, {"C5*", "C5'"}, {"O2*", "O2'"},
    {"O3*", "O3'"}, {"O4*", "O4'"}, {"O5*", "O5'"}};

std::uint8_t add_place(ResidueStructure& structure, std::string_view atom) {
  const auto found = std::find(structure.atoms.begin(), structure.atoms.end(), atom);
  const auto place = static_cast<std::uint8_t>(found - structure.atoms.begin());
  if (found == structure.atoms.end()) structure.atoms.push_back(atom);
  return place;
}

void add_bonds(ResidueStructure& structure, std::string_view text) {
  while (!text.empty()) {
    const std::string_view bond = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(bond.size() + 1, text.size()));
    const std::size_t sign = bond.find_first_of("-=~");
    const BondOrder order = bond[sign] == '-'   ? BondOrder::one
                            : bond[sign] == '=' ? BondOrder::two
                                                : BondOrder::aromatic;
    const std::uint8_t a = add_place(structure, bond.substr(0, sign));
    structure.bonds.push_back({a, add_place(structure, bond.substr(sign + 1)), order});
  }
}

using Table = std::map<std::string_view, ResidueStructure>;

template <std::size_t Count>
void add_table(const Entry (&entries)[Count], std::string_view common, Table& table) {
  for (const Entry& entry : entries) {
    ResidueStructure& structure = table[entry.residue];
    add_bonds(structure, common);
    add_bonds(structure, entry.bonds);
  }
}

const Table& all_structures() {
  static const Table table = [] {
    Table all;
    add_table(kAminoAcids, kAminoAcid, all);
    add_table(kNucleotides, kNucleotide, all);
    return all;
  }();
  return table;
}

std::string_view standard_name(std::string_view residue) {
  const std::string_view amino_acid = standard_amino_acid(residue);
  if (!amino_acid.empty()) return amino_acid;
  const char base = nucleotide_base(residue);
  for (const Entry& entry : kNucleotides) {
    if (base != 0 && entry.residue[0] == base) return entry.residue;
  }
  return {};
}

}  // namespace

const ResidueStructure* residue_structure(std::string_view residue) {
  const auto found = all_structures().find(standard_name(residue));
  return found == all_structures().end() ? nullptr : &found->second;
}

std::string_view structure_name(std::string_view residue, std::string_view atom, bool nucleotide) {
  if (nucleotide) {
    for (const auto& [other, name] : kNucleotideNames) {
      if (other == atom) return name;
    }
    return atom;
  }
  if (residue == "ILE" && atom == "CD") return "CD1";
  for (const auto& [other, name] : kAminoAcidNames) {
    if (other == atom) return name;
  }
  return atom;
}

ResidueStructures::Entry& ResidueStructures::entry(NameId residue) {
  Entry& entry = of_[residue];
  if (!entry.known) {
    entry.known = true;
    entry.structure = residue_structure(names_.text(residue));
    if (entry.structure != nullptr) entry.places.assign(names_.size(), kUnknown);
  }
  return entry;
}

std::uint8_t ResidueStructures::place(NameId residue, NameId atom) {
  Entry& at = entry(residue);
  if (at.structure == nullptr) return kNoPlace;
  std::uint8_t& place = at.places[atom];
  if (place != kUnknown) return place;
  const std::string_view standard = standard_name(names_.text(residue));
  const std::string_view name = structure_name(standard, names_.text(atom), standard.size() == 1);
  const auto& atoms = at.structure->atoms;
  const auto found = std::find(atoms.begin(), atoms.end(), name);
  place = found == atoms.end() ? kNoPlace : static_cast<std::uint8_t>(found - atoms.begin());
  return place;
}

}  // namespace alphascope
