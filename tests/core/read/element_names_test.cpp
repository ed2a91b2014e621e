// SPDX-License-Identifier: GPL-3.0-or-later
// Tests elements from atom names: the same in every format, in whichever column names begin.
#include <cstdio>
#include <string>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

struct Names {
  const char *residue, *atom;
  Element element;
};

// Ions of the chemical component dictionary, then of CHARMM, AMBER, GROMACS and CNS.
constexpr Names kIons[] = {
    {"CA", "CA", 20},   {"FE", "FE", 26},   {"FE2", "FE", 26},  {"CU", "CU", 29},
    {"CU1", "CU", 29},  {"CD", "CD", 48},   {"CO", "CO", 27},   {"3CO", "CO", 27},
    {"NI", "NI", 28},   {"3NI", "NI", 28},  {"HG", "HG", 80},   {"BR", "BR", 35},
    {"BA", "BA", 56},   {"CL", "CL", 17},   {"F", "F", 9},      {"IOD", "I", 53},
    {"I", "I", 53},     {"NA", "NA", 11},   {"K", "K", 19},     {"MG", "MG", 12},
    {"MN", "MN", 25},   {"MN3", "MN", 25},  {"ZN", "ZN", 30},   {"LI", "LI", 3},
    {"RB", "RB", 37},   {"CS", "CS", 55},   {"SR", "SR", 38},   {"PB", "PB", 82},
    {"PD", "PD", 46},   {"PT", "PT", 78},   {"PT4", "PT", 78},  {"AU", "AU", 79},
    {"AU3", "AU", 79},  {"AG", "AG", 47},   {"AL", "AL", 13},   {"OS", "OS", 76},
    {"OS4", "OS", 76},  {"IR", "IR", 77},   {"IR3", "IR", 77},  {"RH3", "RH", 45},
    {"IN", "IN", 49},   {"SM", "SM", 62},   {"CE", "CE", 58},   {"HO3", "HO", 67},
    {"ER3", "ER", 68},  {"EU3", "EU", 63},  {"GD3", "GD", 64},  {"YT3", "Y", 39},
    {"Y1", "Y", 39},    {"YB2", "YB", 70},  {"BS3", "BI", 83},  {"4TI", "TI", 22},
    {"4MO", "MO", 42},  {"4PU", "PU", 94},  {"TA0", "TA", 73},  {"U1", "U", 92},
    {"W", "W", 74},     {"V", "V", 23},     {"CF", "CF", 98},   {"SOD", "SOD", 11},
    {"POT", "POT", 19}, {"CLA", "CLA", 17}, {"CAL", "CAL", 20}, {"CES", "CES", 55},
    {"LIT", "LIT", 3},  {"RUB", "RUB", 37}, {"BAR", "BAR", 56}, {"CAD", "CAD", 48},
    {"CD2", "CD", 48},  {"ZN2", "ZN", 30},  {"CAL", "CA", 20},  {"SOD", "NA", 11},
    {"CES", "CS", 55},  {"Na+", "Na+", 11}, {"NA+", "NA", 11},  {"Cl-", "Cl-", 17},
    {"CL-", "CL", 17},  {"K+", "K+", 19},   {"MG2", "MG", 12},  {"MG2", "MG+2", 12},
    {"CIO", "Na+", 11}, {"IB", "IB", 11},   {"Cal", "Cal", 20}, {"ION", "NA", 11},
    {"ION", "CA", 20}};

std::string formatted(const char* format, const char* atom, const char* residue) {
  char text[200];
  std::snprintf(text, sizeof text, format, atom, residue);
  return text;
}

struct File {
  std::string name, text;
};

// One atom in every format that has atom names but no elements.
std::vector<File> twins(const char* residue, const char* atom, bool hetero) {
  const std::string tag = hetero ? "HETATM" : "ATOM  ";
  const char* const rest = " A   1       1.000   2.000   3.000  1.00  0.00\n";
  std::vector<File> files = {
      {"left.pdb", tag + formatted("    1 %-4s %-3s", atom, residue) + rest},
      {"right.pdb",
       tag +
           formatted(std::string(atom).size() < 4 ? "    1  %-3s %-3s" : "    1 %-4s %-3s", atom,
                     residue) +
           rest},
      {"a.pqr", tag + formatted(" 1 %s %s A 1 1.0 2.0 3.0 0 0\n", atom, residue)},
      {"narrow.crd", "* T\n    1\n    1    1 " + formatted("%2$-4s %1$-4s", atom, residue) +
                         "   1.00000   2.00000   3.00000 A    1      0.00000\n"},
      {"a.cif",
       "data_a\nloop_\n_atom_site.group_PDB\n_atom_site.auth_atom_id\n"
       "_atom_site.auth_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
       "_atom_site.Cartn_z\n" +
           tag + formatted(" %s %s 1.0 2.0 3.0\n", atom, residue)}};
  return files;
}

TEST(ElementNames, IonsAreTheSameInEveryFormatAndColumn) {
  for (const Names& ion : kIons) {
    for (const bool hetero : {true, false}) {
      for (const File& file : twins(ion.residue, ion.atom, hetero)) {
        SCOPED_TRACE(std::string(ion.atom) + " in " + ion.residue + ", " + file.name);
        const Molecule m = read_text(file.name, file.text);
        ASSERT_EQ(m.atoms.size(), 1u);
        EXPECT_EQ(element_symbol(m.atoms[0].element), element_symbol(ion.element));
        EXPECT_EQ(m.atoms[0].kind, ResidueKind::ion);
        EXPECT_EQ(m.text(m.atoms[0].name), ion.atom);
      }
    }
  }
}

TEST(ElementNames, TwinsHaveTheSameRadiiAndCountThemAsGuessed) {
  for (const char* set : {"bondi", "protor", "amber", "alvarez"}) {
    for (const Names& ion : {Names{"CLA", "CLA", 17}, {"CA", "CA", 20}, {"SOD", "SOD", 11}}) {
      std::int32_t radius = 0;
      for (const File& file : twins(ion.residue, ion.atom, true)) {
        SCOPED_TRACE(std::string(set) + " " + ion.atom + " " + file.name);
        BallOptions options;
        ASSERT_TRUE(find_radii_set(set, options.radii));
        const PreparedBalls balls = prepare_balls(read_text(file.name, file.text), options);
        ASSERT_EQ(balls.balls->size(), 1u);
        if (radius == 0) radius = balls.balls->radii[0];
        EXPECT_EQ(balls.balls->radii[0], radius);
        EXPECT_EQ(balls.report.guessed_atoms, 1u);
        ASSERT_EQ(balls.report.guessed.size(), 1u);
        EXPECT_NE(balls.report.guessed[0].source.find("element guessed"), std::string::npos);
      }
    }
  }
}

// Residues that only share their name with an ion, and light atoms whose names begin like a metal.
TEST(ElementNames, ALigandWithAnIonsNameIsALigand) {
  const Names atoms[] = {
      {"CLA", "MG", 12}, {"CLA", "NA", 7},   {"CLA", "CHA", 6},  {"CLA", "C1A", 6},
      {"CLA", "OBD", 8}, {"NO", "N", 7},     {"NO", "O", 8},     {"CO", "C", 6},
      {"CO2", "C", 6},   {"CO2", "O1", 8},   {"CO3", "O3", 8},   {"CIO", "C12", 6},
      {"HEM", "FE", 26}, {"HEM", "NC", 7},   {"LIG", "CL1", 17}, {"LIG", "BR", 35},
      {"LIG", "CM", 6},  {"LIG", "HN", 1},   {"LIG", "HO2'", 1}, {"LIG", "CS", 6},
      {"LIG", "C12", 6}, {"LIG", "SI1", 14}, {"LIG", "SE", 34},  {"SF4", "FE1", 26},
      {"SB", "SB", 51},  {"KR", "KR", 36},   {"XE", "XE", 54}};
  for (const Names& atom : atoms) {
    for (const File& file : twins(atom.residue, atom.atom, false)) {
      SCOPED_TRACE(std::string(atom.atom) + " in " + atom.residue + ", " + file.name);
      const Molecule m = read_text(file.name, file.text);
      EXPECT_EQ(element_symbol(m.atoms[0].element), element_symbol(atom.element));
      EXPECT_NE(m.atoms[0].kind, ResidueKind::ion);
    }
  }
}

TEST(ElementNames, BiopolymersAndWatersAreNoGuess) {
  const Names atoms[] = {{"ALA", "CA", 6},  {"GLU", "CD", 6},  {"LYS", "HG2", 1}, {"HIS", "NE2", 7},
                         {"TIP", "OH2", 8}, {"MSE", "SE", 34}, {"DA", "P", 15},   {"GLU", "HG", 1}};
  for (const Names& atom : atoms) {
    for (const File& file : twins(atom.residue, atom.atom, false)) {
      SCOPED_TRACE(std::string(atom.atom) + " in " + atom.residue + ", " + file.name);
      const Molecule m = read_text(file.name, file.text);
      EXPECT_EQ(element_symbol(m.atoms[0].element), element_symbol(atom.element));
      EXPECT_FALSE(m.atoms[0].element_guessed);
    }
  }
}

// The rule of the columns, which a HETATM of an unknown residue is assumed to keep.
TEST(ElementNames, ColumnsTellCalciumFromCarbon) {
  const auto element = [](const char* name) {
    return read_text("a.pdb", std::string("HETATM    1 ") + name +
                                  " XYZ A   1       1.000   2.000   3.000  1.00  0.00\n")
        .atoms[0]
        .element;
  };
  EXPECT_EQ(element("CA  "), 20);
  EXPECT_EQ(element(" CA "), 6);
  EXPECT_EQ(element("CD  "), 48);
  EXPECT_EQ(element(" CD "), 6);
}

TEST(ElementNames, TheColumnOfElementsGoesBeforeNames) {
  const Molecule m =
      read_text("a.pdb",
                "HETATM    1  CA   CA A   1       1.000   2.000   3.000  1.00  0.00          CA\n"
                "HETATM    2  C   CLA A   2       2.000   2.000   3.000  1.00  0.00           C\n"
                "HETATM    3 X1    ZN A   3       3.000   2.000   3.000  1.00  0.00          ZN\n");
  EXPECT_EQ(m.atoms[0].element, 20);
  EXPECT_EQ(m.atoms[1].element, 6);
  EXPECT_EQ(m.atoms[0].kind, ResidueKind::ion);
  EXPECT_EQ(m.atoms[1].kind, ResidueKind::ligand);
  EXPECT_EQ(m.atoms[2].kind, ResidueKind::ion);
  for (const Atom& atom : m.atoms) EXPECT_FALSE(atom.element_guessed);
  EXPECT_TRUE(m.notes.empty());
}

TEST(ElementNames, XyzFilesWithNamesForSymbols) {
  const Molecule m = read_text(
      "a.xyz", "6\nnames\nSOD 1 2 3\nHB2 2 2 3\nOW 3 2 3\nNa+ 4 2 3\nDu 5 2 3\nCl1 6 2 3\n");
  const Element expected[] = {11, 1, 8, 11, 0, 17};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(m.atoms[k].element, expected[k]) << k;
  EXPECT_EQ(m.notes.size(), 1u);
  EXPECT_TRUE(m.atoms[0].element_guessed);
  EXPECT_FALSE(m.atoms[5].element_guessed);
}

TEST(ElementNames, XyzSymbolsAreReadAsNamesBesideNames) {
  const std::string rows = "CA 1 2 3\nNE 2 2 3\nOG 3 2 3\nCl 4 2 3\nNA 5 2 3\n";
  const Molecule symbols = read_text("a.xyz", "5\n\n" + rows);
  const Molecule names = read_text("a.xyz", "6\n\n" + rows + "HB2 6 2 3\n");
  const Element as_symbols[] = {20, 10, 118, 17, 11}, as_names[] = {6, 7, 8, 17, 11};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(symbols.atoms[k].element, as_symbols[k]) << k;
    EXPECT_EQ(names.atoms[k].element, as_names[k]) << k;
  }
  EXPECT_TRUE(symbols.notes.empty());
  EXPECT_TRUE(names.atoms[0].element_guessed);
  EXPECT_FALSE(names.atoms[3].element_guessed);
}

TEST(ElementNames, ChlorideOfASimulationIsChlorine) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule m = read_molecule(test_data("awkward/1tw7x2_h36.pdb.gz"));
  std::size_t chlorides = 0;
  for (const Atom& atom : m.atoms) chlorides += atom.element == 17 && atom.kind == ResidueKind::ion;
  EXPECT_EQ(chlorides, 16u);
}

}  // namespace
}  // namespace alphascope
