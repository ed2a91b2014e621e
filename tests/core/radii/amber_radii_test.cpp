// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every atom of AMBER's residues against its type. The residue libraries are all_amino94,
// all_aminont94, all_aminoct94 and all_nucleic94 (W. D. Cornell et al., J. Am. Chem. Soc. 117
// (1995) 5179). parm99 keeps their types.
#include "core/radii/amber_radii.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"

namespace alphascope {
namespace {

struct TypedAtom {
  std::string name, type;
};
using TypedAtoms = std::vector<TypedAtom>;

// Reads names and types: "CB:CT HB1:HC".
TypedAtoms atoms_of(const std::string& text) {
  TypedAtoms atoms;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    atoms.push_back({word.substr(0, colon), word.substr(colon + 1)});
  }
  return atoms;
}

// R* of the types in 10^-3 Å. HO and HW are 0 in AMBER and 600 here.
int radius_of_type(const std::string& type) {
  static const std::map<std::string, int> kRadii = {
      {"H", 600},   {"HO", 600},  {"HS", 600},  {"HW", 600},  {"HC", 1487},
      {"H1", 1387}, {"H2", 1287}, {"HP", 1100}, {"HA", 1459}, {"H4", 1409},
      {"H5", 1359}, {"O", 1661},  {"O2", 1661}, {"OH", 1721}, {"OS", 1684},
      {"OW", 1768}, {"S", 2000},  {"SH", 2000}, {"P", 2100}};
  const auto found = kRadii.find(type);
  if (found != kRadii.end()) return found->second;
  return type[0] == 'C' ? 1908 : type[0] == 'N' ? 1824 : 0;
}

Element element_of_type(const std::string& type) {
  return element_from_symbol(type.substr(0, 1));
}

void expect_types(const std::string& residue, const TypedAtoms& atoms,
                  ResidueKind kind = ResidueKind::polymer) {
  Molecule m;
  std::string all;
  for (const TypedAtom& atom : atoms) {
    Atom a;
    a.residue_name = m.names.intern(residue);
    a.name = m.names.intern(atom.name);
    a.element = element_of_type(atom.type);
    a.kind = kind;
    m.atoms.push_back(a);
    all += ' ' + atom.name;
  }
  RadiiLookup lookup(m, RadiiSet::amber, nullptr);
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const AssignedRadius radius = lookup.radius(i);
    EXPECT_EQ(radius.microangstrom, 1000 * radius_of_type(atoms[i].type))
        << residue << ' ' << atoms[i].name << ", type " << atoms[i].type << ", among" << all;
    EXPECT_FALSE(radius.guessed) << residue << ' ' << atoms[i].name;
  }
}

TypedAtoms renamed(TypedAtoms atoms, std::string (*rename)(const std::string&)) {
  for (TypedAtom& atom : atoms) {
    if (atom.type[0] == 'H') atom.name = rename(atom.name);
  }
  return atoms;
}

// "1HB" for "HB1", as in files before 2007.
std::string digit_first(const std::string& name) {
  const bool digit = name.back() >= '0' && name.back() <= '9' && name.size() > 1;
  return digit ? name.back() + name.substr(0, name.size() - 1) : name;
}

std::string deuterium(const std::string& name) {
  return 'D' + name.substr(1);
}

// The side chain of each residue.
const std::map<std::string, std::string>& side_chains() {
  static const std::string kHis = "CB:CT HB2:HC HB3:HC CG:CC ND1:NA CE1:CR HE1:H5 NE2:NB CD2:CV ";
  static const std::map<std::string, std::string> kChains = {
      {"ALA", "CB:CT HB1:HC HB2:HC HB3:HC"},
      {"ARG",
       "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:CT HD2:H1 HD3:H1 NE:N2 HE:H CZ:CA NH1:N2 "
       "HH11:H HH12:H NH2:N2 HH21:H HH22:H"},
      {"ASN", "CB:CT HB2:HC HB3:HC CG:C OD1:O ND2:N HD21:H HD22:H"},
      {"ASP", "CB:CT HB2:HC HB3:HC CG:C OD1:O2 OD2:O2"},
      {"ASH", "CB:CT HB2:HC HB3:HC CG:C OD1:O OD2:OH HD2:HO"},
      {"CYS", "CB:CT HB2:H1 HB3:H1 SG:SH HG:HS"},
      {"CYM", "CB:CT HB2:H1 HB3:H1 SG:SH"},
      {"CYX", "CB:CT HB2:H1 HB3:H1 SG:S"},
      {"GLN", "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:C OE1:O NE2:N HE21:H HE22:H"},
      {"GLU", "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:C OE1:O2 OE2:O2"},
      {"GLH", "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:C OE1:O OE2:OH HE2:HO"},
      {"GLY", ""},
      {"HID", kHis + "HD1:H HD2:H4"},
      {"HIE", kHis + "HE2:H HD2:H4"},
      {"HIP", kHis + "HD1:H HE2:H HD2:H4"},
      {"HIS", kHis + "HD1:H HE2:H HD2:H4"},
      {"HSD", kHis + "HD1:H HD2:H4"},
      {"ILE",
       "CB:CT HB:HC CG2:CT HG21:HC HG22:HC HG23:HC CG1:CT HG12:HC HG13:HC CD1:CT HD11:HC HD12:HC "
       "HD13:HC"},
      {"LEU",
       "CB:CT HB2:HC HB3:HC CG:CT HG:HC CD1:CT HD11:HC HD12:HC HD13:HC CD2:CT HD21:HC HD22:HC "
       "HD23:HC"},
      {"LYS",
       "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:CT HD2:HC HD3:HC CE:CT HE2:HP HE3:HP NZ:N3 "
       "HZ1:H HZ2:H HZ3:H"},
      {"LYN",
       "CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:CT HD2:HC HD3:HC CE:CT HE2:HP HE3:HP NZ:N3 "
       "HZ2:H HZ3:H"},
      {"MET", "CB:CT HB2:HC HB3:HC CG:CT HG2:H1 HG3:H1 SD:S CE:CT HE1:H1 HE2:H1 HE3:H1"},
      {"PHE",
       "CB:CT HB2:HC HB3:HC CG:CA CD1:CA HD1:HA CE1:CA HE1:HA CZ:CA HZ:HA CE2:CA HE2:HA CD2:CA "
       "HD2:HA"},
      {"SER", "CB:CT HB2:H1 HB3:H1 OG:OH HG:HO"},
      {"THR", "CB:CT HB:H1 CG2:CT HG21:HC HG22:HC HG23:HC OG1:OH HG1:HO"},
      {"TRP",
       "CB:CT HB2:HC HB3:HC CG:C* CD1:CW HD1:H4 NE1:NA HE1:H CE2:CN CZ2:CA HZ2:HA CH2:CA HH2:HA "
       "CZ3:CA HZ3:HA CE3:CA HE3:HA CD2:CB"},
      {"TYR",
       "CB:CT HB2:HC HB3:HC CG:CA CD1:CA HD1:HA CE1:CA HE1:HA CZ:C OH:OH HH:HO CE2:CA HE2:HA "
       "CD2:CA HD2:HA"},
      {"VAL", "CB:CT HB:HC CG1:CT HG11:HC HG12:HC HG13:HC CG2:CT HG21:HC HG22:HC HG23:HC"}};
  return kChains;
}

// Tries the spellings of AMBER, of old PDB files and of neutron structures.
void expect_in_all_spellings(const std::string& residue, const std::string& text) {
  const TypedAtoms atoms = atoms_of(text);
  expect_types(residue, atoms);
  expect_types(residue, renamed(atoms, digit_first));
  expect_types(residue, renamed(atoms, deuterium));
}

TEST(AmberRadii, EveryAtomOfTheAminoAcidsHasItsTypesRadius) {
  EXPECT_EQ(side_chains().size(), 28u);
  for (const auto& [residue, side] : side_chains()) {
    const bool glycine = residue == "GLY";
    const std::string h1 = glycine ? "HA2:H1 HA3:H1 " : "HA:H1 ";
    const std::string hp = glycine ? "HA2:HP HA3:HP " : "HA:HP ";
    const std::string rest = "CA:CT C:C " + side;
    expect_in_all_spellings(residue, "N:N H:H O:O " + h1 + rest);
    expect_in_all_spellings(residue, "N:N HN:H O:O " + h1 + rest);
    expect_in_all_spellings(residue, "N:N3 H1:H H2:H H3:H O:O " + hp + rest);
    expect_in_all_spellings(residue, "N:N3 H:H H2:H H3:H O:O " + hp + rest);
    expect_in_all_spellings(residue, "N:N3 HT1:H HT2:H HT3:H O:O " + hp + rest);
    expect_in_all_spellings(residue, "N:N H:H O:O2 OXT:O2 " + h1 + rest);
    expect_in_all_spellings(residue, "N:N H:H O:O OXT:OH HXT:HO " + h1 + rest);
    expect_in_all_spellings('N' + residue, "N:N3 H1:H H2:H H3:H O:O " + hp + rest);
    expect_in_all_spellings('C' + residue, "N:N H:H OC1:O2 OC2:O2 " + h1 + rest);
  }
}

TEST(AmberRadii, ProlineHasNoHydrogenOnItsNitrogenButAtTheEnd) {
  const std::string rest = " CA:CT C:C O:O CB:CT HB2:HC HB3:HC CG:CT HG2:HC HG3:HC CD:CT";
  expect_in_all_spellings("PRO", "N:N HD2:H1 HD3:H1 HA:H1" + rest);
  expect_in_all_spellings("PRO", "N:N3 H2:H H3:H HD2:HP HD3:HP HA:HP" + rest);
  expect_in_all_spellings("PRO", "N:N3 H1:H H2:H HD2:HP HD3:HP HA:HP" + rest);
  expect_in_all_spellings("NPRO", "N:N3 H2:H H3:H HD2:HP HD3:HP HA:HP" + rest);
  expect_in_all_spellings("HYP",
                          "N:N CA:CT HA:H1 C:C O:O CB:CT HB2:HC HB3:HC CG:CT HG:H1 OD1:OH HD1:HO "
                          "CD:CT HD22:H1 HD23:H1");
}

TEST(AmberRadii, TheAcidsHydrogenTellsWhichOxygenIsAHydroxyl) {
  expect_types("ASP", atoms_of("N:N H:H CA:CT HA:H1 CG:C OD1:O OD2:OH HD2:HO"));
  expect_types("ASP", atoms_of("N:N H:H CA:CT HA:H1 CG:C OD1:OH OD2:O HD1:HO"));
  expect_types("GLU", atoms_of("N:N H:H CA:CT HA:H1 CD:C OE1:O OE2:OH HE2:HO"));
  expect_types("GLU", atoms_of("N:N H:H CA:CT HA:H1 CD:C OE1:OH OE2:O HE1:HO"));
  expect_types("ASH", atoms_of("OD1:O OD2:OH"));  // without hydrogens, by its name
}

TEST(AmberRadii, CapsAreWhatTheyAre) {
  expect_in_all_spellings("ACE", "CH3:CT HH31:HC HH32:HC HH33:HC C:C O:O");
  expect_in_all_spellings("ACE", "CH3:CT H1:HC H2:HC H3:HC C:C O:O");
  expect_in_all_spellings("NME", "N:N H:H CH3:CT HH31:H1 HH32:H1 HH33:H1");
  expect_in_all_spellings("NME", "N:N HN2:H C:CT H1:H1 H2:H1 H3:H1");
  expect_in_all_spellings("NMA", "N:N H:H CA:CT HA1:H1 HA2:H1 HA3:H1");
  expect_in_all_spellings("NH2", "N:N HN1:H HN2:H");
  expect_in_all_spellings("NHE", "N:N H1:H H2:H");
  // CHARMM puts both caps into the residues at the chain ends.
  expect_types("ALA", atoms_of("CAY:CT HY1:HC HY2:HC HY3:HC CY:C OY:O N:N HN:H CA:CT HA:H1 CB:CT "
                               "HB1:HC HB2:HC HB3:HC C:C O:O NT:N HNT:H CAT:CT HT1:H1 HT2:H1 "
                               "HT3:H1"));
}

// Bases, and phosphate and sugar as the backbone of each spelling.
const std::map<char, std::string>& bases() {
  static const std::map<char, std::string> kBases = {
      {'A', " N9:N* C8:CK H8:H5 N7:NB C5:CB C6:CA N6:N2 H61:H H62:H N1:NC C2:CQ H2:H5 N3:NC C4:CB"},
      {'G',
       " N9:N* C8:CK H8:H5 N7:NB C5:CB C6:C O6:O N1:NA H1:H C2:CA N2:N2 H21:H H22:H N3:NC C4:CB"},
      {'C', " N1:N* C6:CM H6:H4 C5:CM H5:HA C4:CA N4:N2 H41:H H42:H N3:NC C2:C O2:O"},
      {'U', " N1:N* C6:CM H6:H4 C5:CM H5:HA C4:C O4:O N3:NA H3:H C2:C O2:O"},
      {'T', " N1:N* C6:CM H6:H4 C5:CM C7:CT H71:HC H72:HC H73:HC C4:C O4:O N3:NA H3:H C2:C O2:O"}};
  return kBases;
}

// Hydrogens of the base with the digit first: "1H6" for "H61", but "H6" stays.
TypedAtoms old_base(char base) {
  TypedAtoms atoms = atoms_of(bases().at(base));
  for (TypedAtom& atom : atoms) {
    if (atom.type[0] != 'H' || atom.name.size() != 3) continue;
    atom.name = base == 'T' ? atom.name.substr(2) + "H5M" : digit_first(atom.name);
  }
  return atoms;
}

void expect_nucleotide(const std::string& residue, char base, const std::string& backbone) {
  TypedAtoms atoms = atoms_of(backbone + bases().at(base));
  expect_types(residue, atoms);
  atoms = atoms_of(backbone);
  for (const TypedAtom& atom : old_base(base)) atoms.push_back(atom);
  expect_types(residue, atoms);
}

constexpr const char* kSugar =
    "P:P C5':CT C4':CT O4':OS C1':CT C3':CT C2':CT H4':H1 H1':H2 H3':H1 ";
constexpr const char* kOldSugar =
    "P:P C5*:CT C4*:CT O4*:OS C1*:CT C3*:CT C2*:CT H4*:H1 H1*:H2 H3*:H1 ";

TEST(AmberRadii, EveryAtomOfDnaInThreeSpellings) {
  for (const char base : {'A', 'G', 'C', 'T'}) {
    const std::string d = std::string("D") + base;
    // PDB format 3, AMBER, and PDB format 2, which gives the residue RNA's name.
    const std::string now = std::string(kSugar) + "OP1:O2 OP2:O2 H5':H1 H5'':H1 H2':HC H2'':HC ";
    const std::string amber =
        std::string(kSugar) + "O1P:O2 O2P:O2 H5'1:H1 H5'2:H1 H2'1:HC H2'2:HC ";
    const std::string old =
        std::string(kOldSugar) + "O1P:O2 O2P:O2 1H5*:H1 2H5*:H1 1H2*:HC 2H2*:HC ";
    const std::string old_primes =
        std::string(kSugar) + "O1P:O2 O2P:O2 1H5':H1 2H5':H1 1H2':HC 2H2':HC ";
    for (const std::string& sugar : {now, amber, old_primes}) {
      expect_nucleotide(d, base, sugar + "O5':OS O3':OS");
      expect_nucleotide(d + "5", base, sugar + "H5T:HO O5':OH O3':OS");
      expect_nucleotide(d + "3", base, sugar + "O5':OS O3':OH H3T:HO");
      expect_nucleotide(d, base, sugar + "HO5':HO O5':OH O3':OH HO3':HO");
    }
    expect_nucleotide(std::string(1, base), base, old + "O5*:OS O3*:OS");
    expect_nucleotide(std::string(1, base), base, old + "H5T:HO O5*:OH O3*:OH H3T:HO");
  }
  expect_nucleotide("ADE", 'A',
                    std::string(kSugar) + "H5':H1 H5'':H1 H2':HC H2'':HC O5':OS O3':OS");
}

TEST(AmberRadii, EveryAtomOfRnaInFourSpellings) {
  for (const char base : {'A', 'G', 'C', 'U'}) {
    const std::string r(1, base);
    const std::string now =
        std::string(kSugar) + "OP1:O2 OP2:O2 H5':H1 H5'':H1 H2':H1 O2':OH HO2':HO ";
    const std::string amber =
        std::string(kSugar) + "O1P:O2 O2P:O2 H5'1:H1 H5'2:H1 H2'1:H1 O2':OH HO'2:HO ";
    const std::string old =
        std::string(kOldSugar) + "O1P:O2 O2P:O2 1H5*:H1 2H5*:H1 H2*:H1 O2*:OH 2HO*:HO ";
    const std::string charmm =
        std::string(kSugar) + "O1P:O2 O2P:O2 H5':H1 H5'':H1 H2'':H1 O2':OH H2':HO ";
    for (const std::string& sugar : {now, amber}) {
      expect_nucleotide(r, base, sugar + "O5':OS O3':OS");
      expect_nucleotide("R" + r, base, sugar + "O5':OS O3':OS");
      expect_nucleotide("R" + r + "5", base, sugar + "H5T:HO O5':OH O3':OS");
      expect_nucleotide(r + "3", base, sugar + "O5':OS O3':OH H3T:HO");
      expect_nucleotide(r, base, sugar + "HO5':HO O5':OH O3':OH HO3':HO");
    }
    expect_nucleotide(r, base, old + "O5*:OS O3*:OS");
    expect_nucleotide(r, base, charmm + "O5':OS O3':OS");
  }
  expect_nucleotide("GUA", 'G',
                    std::string(kSugar) + "H5':H1 H5'':H1 H2'':H1 O2':OH H2':HO O5':OS O3':OS");
}

AssignedRadius radius(const char* residue, const char* name, const char* element,
                      ResidueKind kind) {
  Molecule m;
  Atom a;
  a.residue_name = m.names.intern(residue);
  a.name = m.names.intern(name);
  a.element = element_from_symbol(element);
  a.kind = kind;
  m.atoms = {a};
  return RadiiLookup(m, RadiiSet::amber, nullptr).radius(0);
}

TEST(AmberRadii, IonsAreIonsAndHalogensOfMoleculesAreNot) {
  const std::pair<const char*, int> kIons[] = {{"Li", 1137}, {"Na", 1868}, {"Mg", 793},
                                               {"Cl", 2470}, {"K", 2658},  {"Ca", 1713},
                                               {"Zn", 1100}, {"Rb", 2956}, {"Cs", 3395}};
  for (const auto& [element, milli] : kIons) {
    const AssignedRadius ion = radius("ION", element, element, ResidueKind::ion);
    EXPECT_EQ(ion.microangstrom, milli * 1000) << element;
    EXPECT_FALSE(ion.guessed) << element;
  }
  const std::pair<const char*, int> kCovalent[] = {
      {"F", 1750}, {"Cl", 1948}, {"Br", 2220}, {"I", 2350}};
  for (const auto& [element, milli] : kCovalent) {
    const AssignedRadius bound = radius("LIG", element, element, ResidueKind::ligand);
    EXPECT_EQ(bound.microangstrom, milli * 1000) << element;
    EXPECT_FALSE(bound.guessed) << element;
  }
  for (const char* element : {"F", "Br", "I"}) {
    EXPECT_TRUE(radius("ION", element, element, ResidueKind::ion).guessed)
        << "parm99 has no " << element << " ion";
  }
}

TEST(AmberRadii, WatersOfEveryNameAreTip3p) {
  for (const char* name : {"HOH", "WAT", "TIP3", "SOL", "DOD"}) {
    expect_types(name, atoms_of("O:OW H1:HW H2:HW"), ResidueKind::water);
  }
}

TEST(AmberRadii, TheBackboneOfAModifiedResidueIsThatOfAll) {
  for (const char* name : {"SME", "XYZ"}) {
    expect_types(name, atoms_of("N:N H:H CA:CT HA:H1 C:C O:O CB:CT"));
  }
  Molecule m;
  for (const auto& [atom, element] : {std::pair{"N", "N"},
                                      {"CA", "C"},
                                      {"C", "C"},
                                      {"O", "O"},
                                      {"H", "H"},
                                      {"HB2", "H"},
                                      {"OE", "O"}}) {
    Atom a;
    a.residue_name = m.names.intern("SME");
    a.name = m.names.intern(atom);
    a.element = element_from_symbol(element);
    m.atoms.push_back(a);
  }
  RadiiLookup lookup(m, RadiiSet::amber, nullptr);
  EXPECT_EQ(lookup.radius(4).microangstrom, 600000);
  EXPECT_TRUE(lookup.radius(5).guessed);
  EXPECT_TRUE(lookup.radius(6).guessed);
  for (Atom& a : m.atoms) a.kind = ResidueKind::ligand;
  EXPECT_TRUE(RadiiLookup(m, RadiiSet::amber, nullptr).radius(4).guessed);
}

TEST(AmberRadii, WhatIsNotTypedIsSaidToBeGuessed) {
  EXPECT_FALSE(radius("LIG", "C1", "C", ResidueKind::ligand).guessed)
      << "every carbon has one radius";
  EXPECT_TRUE(radius("LIG", "O1", "O", ResidueKind::ligand).guessed);
  EXPECT_TRUE(radius("LIG", "H1", "H", ResidueKind::ligand).guessed);
  EXPECT_EQ(radius("LIG", "H1", "H", ResidueKind::ligand).microangstrom, 1487000);
  EXPECT_TRUE(radius("UNK", "HB", "H", ResidueKind::polymer).guessed);
}

}  // namespace
}  // namespace alphascope
