// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every value of every radii set against tables copied from the sources in
// docs/file-formats.md. The tables of the program are not used here.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"

namespace alphascope {
namespace {

using Table = std::map<std::string, int>;  // symbol or type; 10^-3 Å

Table table(const std::string& text) {
  Table result;
  std::istringstream words(text);
  std::string name;
  for (int milli = 0; words >> name >> milli;) EXPECT_TRUE(result.emplace(name, milli).second);
  return result;
}

// A. Bondi, J. Phys. Chem. 68 (1964) 441, tables I and XII-XIV.
const Table kBondi = table(
    "H 1200 He 1400 Li 1820 C 1700 N 1550 O 1520 F 1470 Ne 1540 Na 2270 Mg 1730 Si 2100 P 1800 "
    "S 1800 Cl 1750 Ar 1880 K 2750 Ni 1630 Cu 1400 Zn 1390 Ga 1870 As 1850 Se 1900 Br 1850 "
    "Kr 2020 Pd 1630 Ag 1720 Cd 1580 In 1930 Sn 2170 Te 2060 I 1980 Xe 2160 Pt 1750 Au 1660 "
    "Hg 1550 Tl 1960 Pb 2020 U 1860");

// M. Mantina et al., J. Phys. Chem. A 113 (2009) 5806, table 12: elements that Bondi left out.
const Table kMantina = table(
    "Be 1530 B 1920 Al 1840 Ca 2310 Ge 2110 Rb 3030 Sr 2490 Sb 2060 Cs 3430 Ba 2680 Bi 2070 "
    "Po 1970 At 2020 Rn 2200 Fr 3480 Ra 2830");

// R. D. Shannon, Acta Cryst. A 32 (1976) 751, table 1, effective radii for coordination number 6.
// The first part has them to 0.01 Å, as in the CRC Handbook.
const Table kShannon = table(
    "Li 760 Be 450 F 1330 Na 1020 Mg 720 Al 540 Cl 1810 K 1380 Ca 1000 Sc 750 Ti 860 V 790 Cr 730 "
    "Mn 830 Fe 610 Co 650 Ni 690 Cu 730 Zn 740 Ga 620 Br 1960 Rb 1520 Sr 1180 Zr 720 Mo 690 "
    "Tc 650 Pd 860 Cd 950 Sn 690 I 2200 Cs 1670 Ba 1350 Pt 800 Au 1370 Hg 1020 Pb 1190 Bi 1030 "
    "Y 900 Ru 680 Rh 665 Ag 1150 In 800 La 1032 Ce 1010 Pr 990 Nd 983 Sm 958 Eu 947 Gd 938 Tb 923 "
    "Dy 912 Ho 901 Er 890 Tm 880 Yb 868 Lu 861 W 660 Re 630 Os 630 Ir 680 Tl 1500");

// S. Alvarez, Dalton Trans. 42 (2013) 8617, table 1.
const Table kAlvarez = table(
    "H 1200 He 1430 Li 2120 Be 1980 B 1910 C 1770 N 1660 O 1500 F 1460 Ne 1580 Na 2500 Mg 2510 "
    "Al 2250 Si 2190 P 1900 S 1890 Cl 1820 Ar 1830 K 2730 Ca 2620 Sc 2580 Ti 2460 V 2420 Cr 2450 "
    "Mn 2450 Fe 2440 Co 2400 Ni 2400 Cu 2380 Zn 2390 Ga 2320 Ge 2290 As 1880 Se 1820 Br 1860 "
    "Kr 2250 Rb 3210 Sr 2840 Y 2750 Zr 2520 Nb 2560 Mo 2450 Tc 2440 Ru 2460 Rh 2440 Pd 2150 "
    "Ag 2530 Cd 2490 In 2430 Sn 2420 Sb 2470 Te 1990 I 2040 Xe 2060 Cs 3480 Ba 3030 La 2980 "
    "Ce 2880 Pr 2920 Nd 2950 Sm 2900 Eu 2870 Gd 2830 Tb 2790 Dy 2870 Ho 2810 Er 2830 Tm 2790 "
    "Yb 2800 Lu 2740 Hf 2630 Ta 2530 W 2570 Re 2490 Os 2480 Ir 2410 Pt 2290 Au 2320 Hg 2450 "
    "Tl 2470 Pb 2600 Bi 2540 Ac 2800 Th 2930 Pa 2880 U 2710 Np 2820 Pu 2810 Am 2830 Cm 3050 "
    "Bk 3400 Cf 3050 Es 2700");

// RasMol's source: 275, 387, 350, 337, 470 and 452 units of 1/250 Å.
const Table kRasmol = table("H 1100 C 1548 N 1400 O 1348 P 1880 S 1808");

// R* of parm99. C and N have one radius for all types.
const Table kAmber = table(
    "Li 1137 C 1908 N 1824 F 1750 Na 1868 Mg 793 P 2100 S 2000 Cl 1948 K 2658 Ca 1713 Zn 1100 "
    "Br 2220 Rb 2956 I 2350 Cs 3395");
const std::set<std::string> kNoAmberIon = {"F", "Br", "I"};

// Radii of a united-atom set for an atom of a ligand, whose type is unknown.
const Table kProtorTypical = table("C 1760 N 1640 O 1460 P 1800 S 1770 Se 1900");
const Table kNaccessTypical = table("C 1760 N 1650 O 1400 P 1900 S 1850 Se 1800");

std::optional<int> in(const Table& values, const std::string& symbol) {
  const auto found = values.find(symbol);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

struct Expected {
  int milli = 0;
  bool guessed = false;
};

// The table "When a set has no radius for an atom" of docs/file-formats.md.
Expected without_value(RadiiSet set, const std::string& symbol, bool ion) {
  const bool van_der_waals = set == RadiiSet::bondi || set == RadiiSet::alvarez;
  const std::set<std::string> halogens = {"F", "Cl", "Br", "I"};
  if (!van_der_waals && (ion || !halogens.contains(symbol))) {
    if (const auto milli = in(kShannon, symbol)) return {*milli, true};
  }
  if (const auto milli = in(kBondi, symbol)) return {*milli, true};
  if (const auto milli = in(kMantina, symbol)) return {*milli, true};
  return {2000, true};
}

Expected expected(RadiiSet set, const std::string& symbol, bool ion) {
  const auto of = [&](const Table& values, bool guessed) -> Expected {
    const auto milli = in(values, symbol);
    return milli ? Expected{*milli, guessed} : without_value(set, symbol, ion);
  };
  switch (set) {
    case RadiiSet::alvarez:
      return of(kAlvarez, false);
    case RadiiSet::rasmol:
      return of(kRasmol, false);
    case RadiiSet::protor:
    case RadiiSet::castp:
      return of(kProtorTypical, true);
    case RadiiSet::naccess:
      return of(kNaccessTypical, true);
    case RadiiSet::amber:
      if (symbol == "H") return {1487, true};
      if (symbol == "O") return {1661, true};
      if (ion && symbol == "Cl") return {2470, false};
      if (ion && kNoAmberIon.contains(symbol)) return without_value(set, symbol, ion);
      return of(kAmber, false);
    default:
      return of(kBondi, false);
  }
}

AssignedRadius radius(RadiiSet set, const std::string& residue, const std::string& name,
                      Element element, ResidueKind kind) {
  Molecule m;
  Atom a;
  a.residue_name = m.names.intern(residue);
  a.name = m.names.intern(name);
  a.element = element;
  a.kind = kind;
  m.atoms = {a};
  return RadiiLookup(m, set, nullptr).radius(0);
}

constexpr RadiiSet kSets[] = {RadiiSet::bondi,   RadiiSet::protor, RadiiSet::castp,
                              RadiiSet::alvarez, RadiiSet::amber,  RadiiSet::naccess,
                              RadiiSet::rasmol};

TEST(RadiiTables, EveryElementOfEverySet) {
  for (const RadiiSet set : kSets) {
    for (const bool ion : {false, true}) {
      for (int z = 1; z <= kHeaviestElement; ++z) {
        const auto element = static_cast<Element>(z);
        const std::string symbol(element_symbol(element));
        const AssignedRadius found = radius(set, ion ? "ION" : "LIG", symbol, element,
                                            ion ? ResidueKind::ion : ResidueKind::ligand);
        const Expected right = expected(set, symbol, ion);
        EXPECT_EQ(found.microangstrom, 1000 * right.milli)
            << radii_set_info(set).id << ' ' << symbol << (ion ? " ion" : "");
        EXPECT_EQ(found.guessed, right.guessed)
            << radii_set_info(set).id << ' ' << symbol << (ion ? " ion" : "");
      }
    }
  }
  EXPECT_EQ(radius(RadiiSet::bondi, "LIG", "I1", 53, ResidueKind::ligand).microangstrom, 1980000);
}

// Heavy atoms with the types of Tsai et al. Carbon has its number of bonds: 4, 3, or 3h with one
// hydrogen. N and S are plain. Oxygen has one neighbour (O1) or two (O2). NACCESS has a type of its
// own for NZ of lysine.
const std::map<std::string, std::string> kSideChains = {
    {"ALA", "CB:4"},
    {"ARG", "CB:4 CG:4 CD:4 NE:N CZ:3 NH1:N NH2:N"},
    {"ASN", "CB:4 CG:3 OD1:O1 ND2:N"},
    {"ASP", "CB:4 CG:3 OD1:O1 OD2:O2"},
    {"CYS", "CB:4 SG:S"},
    {"GLN", "CB:4 CG:4 CD:3 OE1:O1 NE2:N"},
    {"GLU", "CB:4 CG:4 CD:3 OE1:O1 OE2:O2"},
    {"GLY", ""},
    {"HIS", "CB:4 CG:3 ND1:N CE1:3h NE2:N CD2:3h"},
    {"ILE", "CB:4 CG1:4 CG2:4 CD1:4"},
    {"LEU", "CB:4 CG:4 CD1:4 CD2:4"},
    {"LYS", "CB:4 CG:4 CD:4 CE:4 NZ:N4"},
    {"MET", "CB:4 CG:4 SD:S CE:4"},
    {"MSE", "CB:4 CG:4 SE:Se CE:4"},
    {"PHE", "CB:4 CG:3 CD1:3h CD2:3h CE1:3h CE2:3h CZ:3h"},
    {"PRO", "CB:4 CG:4 CD:4"},
    {"SEC", "CB:4 SE:Se"},
    {"SER", "CB:4 OG:O2"},
    {"THR", "CB:4 OG1:O2 CG2:4"},
    {"TRP", "CB:4 CG:3 CD1:3h NE1:N CE2:3 CD2:3 CE3:3h CZ3:3h CH2:3h CZ2:3h"},
    {"TYR", "CB:4 CG:3 CD1:3h CD2:3h CE1:3h CE2:3h CZ:3 OH:O2"},
    {"VAL", "CB:4 CG1:4 CG2:4"}};

const Table kProtorTypes =
    table("4 1880 3 1610 3h 1760 N 1640 N4 1640 O1 1420 O2 1460 S 1770 Se 1900");
const Table kNaccessTypes =
    table("4 1870 3 1760 3h 1760 N 1650 N4 1500 O1 1400 O2 1400 S 1850 Se 1800");

Element element_of(const std::string& atom) {
  return atom == "SE" ? 34 : element_from_symbol(atom.substr(0, 1));
}

// Expects for "CB:4 OG:O2" the radius of each type.
void expect_types(RadiiSet set, const std::string& residue, const std::string& atoms,
                  const Table& types) {
  std::istringstream words(atoms);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    const std::string atom = word.substr(0, colon);
    const AssignedRadius found = radius(set, residue, atom, element_of(atom), ResidueKind::polymer);
    EXPECT_EQ(found.microangstrom, 1000 * types.at(word.substr(colon + 1)))
        << radii_set_info(set).id << ' ' << residue << ' ' << atom;
    EXPECT_FALSE(found.guessed) << radii_set_info(set).id << ' ' << residue << ' ' << atom;
  }
}

TEST(RadiiTables, EveryHeavyAtomOfTheAminoAcids) {
  ASSERT_EQ(kSideChains.size(), 22u);
  for (const auto& [residue, side] : kSideChains) {
    const std::string backbone = "N:N CA:4 C:3 O:O1 OXT:O2 OT1:O1 OT2:O2 ";
    expect_types(RadiiSet::protor, residue, backbone + side, kProtorTypes);
    expect_types(RadiiSet::naccess, residue, backbone + side, kNaccessTypes);
    for (const char end : {'N', 'C'}) {
      expect_types(RadiiSet::protor, end + residue, backbone + side, kProtorTypes);
    }
    // For CASTp both oxygens of a carboxyl group have 1.40 Å: OXT, and those of ASP and GLU.
    Table castp = kProtorTypes;
    castp["acid"] = 1400;
    std::string acid = side;
    if (residue == "ASP") acid = "CB:4 CG:3 OD1:acid OD2:acid";
    if (residue == "GLU") acid = "CB:4 CG:4 CD:3 OE1:acid OE2:acid";
    expect_types(RadiiSet::castp, residue, "N:N CA:4 C:3 O:O1 OXT:acid OT2:acid " + acid, castp);
  }
}

TEST(RadiiTables, NamesOfProtonationStatesAreTheirAminoAcids) {
  const std::pair<const char*, const char*> kSame[] = {
      {"HID", "HIS"}, {"HIE", "HIS"}, {"HIP", "HIS"},  {"HSD", "HIS"}, {"HSE", "HIS"},
      {"HSP", "HIS"}, {"CYX", "CYS"}, {"CYM", "CYS"},  {"ASH", "ASP"}, {"GLH", "GLU"},
      {"LYN", "LYS"}, {"ARN", "ARG"}, {"ASPP", "ASP"}, {"GLUP", "GLU"}};
  for (const auto& [name, amino_acid] : kSame) {
    expect_types(RadiiSet::protor, name, kSideChains.at(amino_acid), kProtorTypes);
    expect_types(RadiiSet::naccess, name, kSideChains.at(amino_acid), kNaccessTypes);
  }
}

// s: sugar; b: ring carbon without hydrogen; h: ring carbon with hydrogen; m: methyl.
TEST(RadiiTables, EveryHeavyAtomOfTheNucleotides) {
  const Table protor = table("s 1880 b 1610 h 1760 m 1880 N 1640 O1 1420 O2 1460 P 1800");
  const Table naccess = table("s 1800 b 1800 h 1800 m 1800 N 1600 O1 1400 O2 1400 P 1900");
  const std::string sugar =
      "P:P OP1:O1 O1P:O1 OP2:O2 O5':O2 C5':s C5*:s C4':s O4':O2 C3':s O3':O2 C2':s O2':O2 C1':s ";
  const std::map<std::string, std::string> bases = {
      {"A", "N9:N C8:h N7:N C5:b C6:b N6:N N1:N C2:h N3:N C4:b"},
      {"G", "N9:N C8:h N7:N C5:b C6:b O6:O1 N1:N C2:b N2:N N3:N C4:b"},
      {"I", "N9:N C8:h N7:N C5:b C6:b O6:O1 N1:N C2:h N3:N C4:b"},
      {"C", "N1:N C2:b O2:O1 N3:N C4:b N4:N C5:h C6:h"},
      {"U", "N1:N C2:b O2:O1 N3:N C4:b O4:O1 C5:h C6:h"},
      {"T", "N1:N C2:b O2:O1 N3:N C4:b O4:O1 C5:b C7:m C5M:m C6:h"}};
  const std::map<std::string, std::string> whole = {
      {"A", "ADE"}, {"C", "CYT"}, {"G", "GUA"}, {"T", "THY"}, {"U", "URA"}};
  for (const auto& [base, atoms] : bases) {
    std::vector<std::string> names = {base,       "D" + base,       "R" + base,      base + "3",
                                      base + "5", "D" + base + "3", "R" + base + "5"};
    if (whole.contains(base)) names.push_back(whole.at(base));
    for (const std::string& name : names) {
      expect_types(RadiiSet::protor, name, sugar + atoms, protor);
      expect_types(RadiiSet::castp, name, sugar + atoms, protor);
      expect_types(RadiiSet::naccess, name, sugar + atoms, naccess);
    }
  }
}

}  // namespace
}  // namespace alphascope
