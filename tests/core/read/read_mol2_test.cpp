// SPDX-License-Identifier: GPL-3.0-or-later
// Tests MOL2 of Tripos.
#include <string>

#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::string all_notes(const Molecule& m) {
  std::string notes;
  for (const std::string& note : m.notes) notes += note + "\n";
  return notes;
}

// One molecule with these atoms, followed by the rest.
std::string molecule(int count, const std::string& atoms, const std::string& rest = "") {
  return "# made by hand\n@<TRIPOS>MOLECULE\nbenzamidine\n " + std::to_string(count) +
         " 1 1 0 0\nSMALL\nGASTEIGER\n\n@<TRIPOS>ATOM\n" + atoms + rest;
}

TEST(ReadMol2, AtomsOfALigand) {
  const Molecule m = read_text(
      "a.mol2",
      molecule(3,
               "      1 C1          1.2500   -2.5000    3.7501 C.ar    1  BEN1       -0.0300\n"
               "      2 N1         10.0000    0.0000    0.0000 N.pl3   1  BEN1        0.2\n\n"
               "# between\n      3 H1 1 2 3 H 1 BEN1 0.1 DICT\n",
               "@<TRIPOS>BOND\n 1 1 2 ar\n 2 2 3 1\n@<TRIPOS>COMMENT\nanything 1 2\n"));
  EXPECT_EQ(m.format, "MOL2");
  EXPECT_EQ(m.title, "benzamidine");
  ASSERT_EQ(m.atoms.size(), 3u);
  EXPECT_EQ(m.lattice.digits, 4);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{12500, -25000, 37501}));
  EXPECT_EQ(m.atoms[0].element, 6);
  EXPECT_EQ(m.atoms[1].element, 7);
  EXPECT_EQ(m.atoms[2].element, 1);
  EXPECT_FALSE(m.atoms[0].element_guessed);
  EXPECT_EQ(m.text(m.atoms[0].residue_name), "BEN");
  EXPECT_EQ(m.atoms[0].residue_number, 1);
  EXPECT_EQ(m.atoms[0].kind, ResidueKind::ligand);
  EXPECT_EQ(all_notes(m).find("guessed"), std::string::npos) << all_notes(m);
}

TEST(ReadMol2, TypesGiveElementsAndNothingElse) {
  const struct {
    const char *name, *type;
    Element element;
    bool guessed;
  } cases[] = {
      {"X1", "C.3", 6, false},
      {"X2", "O.co2", 8, false},
      {"X3", "S.O2", 16, false},
      {"X4", "P.3", 15, false},
      {"CL1", "Cl", 17, false},
      {"CA", "Ca", 20, false},
      {"X5", "Cr.th", 24, false},
      {"X6", "H.spc", 1, false},
      {"C7", "ca", 6, true},
      {"C8", "CA", 6, true},
      {"N9", "na", 7, true},
      {"O1", "os", 8, true},
      {"X7", "Het", kUnknownElement, false},
  };
  for (const auto& c : cases) {
    const Molecule m =
        read_text("a.mol2", molecule(1, std::string("1 ") + c.name + " 0 0 0 " + c.type + "\n"));
    ASSERT_EQ(m.atoms.size(), 1u);
    EXPECT_EQ(m.atoms[0].element, c.element) << c.type;
    EXPECT_EQ(m.atoms[0].element_guessed, c.guessed) << c.type;
    const bool counted = all_notes(m).find("Elements guessed") != std::string::npos;
    EXPECT_EQ(counted, c.guessed) << c.type << ": " << all_notes(m);
  }
  const Molecule pair = read_text("a.mol2", molecule(2, "1 C1 0 0 0 C.3\n2 LP1 0.3 0 0 LP\n"));
  EXPECT_EQ(pair.atoms[1].kind, ResidueKind::dummy);
}

// A protein as SYBYL writes it: names of residues follow the atoms.
TEST(ReadMol2, SubstructuresAreResidues) {
  const Molecule m = read_text(
      "a.mol2", molecule(7,
                         "1 N   0.0 0.0 0.0 N.4 1 GLY16A\n2 CA 1.5 0.0 0.0 C.3 1 GLY16A\n"
                         "3 C   2.0 1.4 0.0 C.2 1 GLY16A\n4 O  1.3 2.4 0.0 O.2 1 GLY16A\n"
                         "5 P1 20 0 0 P.3 2 PO4\n6 O 30 0 0 O.3 3 HOH301\n7 C1 40 0 0 C.3 4 <0>\n",
                         "@<TRIPOS>SUBSTRUCTURE\n 1 GLY16A 1 RESIDUE 4 B GLY 1 ****\n"
                         " 2 PO4 5 GROUP 0 **** **** 0\n 3 HOH301 6 GROUP 0 W HOH\n"));
  ASSERT_EQ(m.atoms.size(), 7u);
  EXPECT_EQ(m.text(m.atoms[1].residue_name), "GLY");
  EXPECT_EQ(m.atoms[1].residue_number, 16);
  EXPECT_EQ(m.atoms[1].insertion_code, 'A');
  EXPECT_EQ(m.text(m.atoms[1].chain), "B");
  EXPECT_EQ(m.atoms[1].element, 6);
  EXPECT_EQ(m.atoms[1].kind, ResidueKind::polymer);
  EXPECT_EQ(m.text(m.atoms[4].residue_name), "PO4");
  EXPECT_EQ(m.atoms[4].residue_number, 2);
  EXPECT_EQ(m.atoms[4].kind, ResidueKind::ligand);
  EXPECT_EQ(m.text(m.atoms[4].chain), "");
  EXPECT_EQ(m.text(m.atoms[5].residue_name), "HOH");
  EXPECT_EQ(m.atoms[5].residue_number, 301);
  EXPECT_EQ(m.atoms[5].kind, ResidueKind::water);
  EXPECT_EQ(m.text(m.atoms[6].residue_name), "");
}

// A residue with an unknown name between two of a chain. Its bonds show that it belongs there.
TEST(ReadMol2, BondsAreEvidence) {
  const std::string atoms =
      "11 N 0 0 0 N.am 1 ALA1\n12 CA 1.5 0 0 C.3 1 ALA1\n13 C 2 1.4 0 C.2 1 ALA1\n"
      "14 N1 50 0 0 N.am 2 XYZ2\n15 C1 51.5 0 0 C.3 2 XYZ2\n16 C2 52 1.4 0 C.2 2 XYZ2\n"
      "17 N 90 0 0 N.am 3 ALA3\n18 CA 91.5 0 0 C.3 3 ALA3\n19 C 92 1.4 0 C.2 3 ALA3\n";
  const std::string bonds = "@<TRIPOS>BOND\n1 13 14 am\n2 16 17 am\n";
  const Molecule bound = read_text("a.mol2", molecule(9, atoms, bonds));
  EXPECT_EQ(bound.text(bound.atoms[3].residue_name), "XYZ");
  EXPECT_EQ(bound.atoms[3].kind, ResidueKind::polymer);
  EXPECT_EQ(bound.atoms[3].why, ResidueReason::bond_record);
  EXPECT_NE(read_text("a.mol2", molecule(9, atoms)).atoms[3].why, ResidueReason::bond_record);
}

TEST(ReadMol2, MoleculesBecomeModels) {
  const Molecule m =
      read_text("a.mol2", molecule(1, "1 C1 1 2 3 C.3 1 LIG1\n") +
                              molecule(2, "1 C1 4 5 6 C.3 1 LIG1\n2 O1 7 8 9 O.3 1 LIG1\n",
                                       "@<TRIPOS>BOND\n1 1 2 1\n"));
  ASSERT_EQ(m.models.size(), 2u);
  EXPECT_EQ(m.models[1].begin, 1u);
  EXPECT_EQ(m.models[1].end, 3u);
  EXPECT_EQ(m.atoms[2].position, (LatticePoint{7000, 8000, 9000}));
}

TEST(ReadMol2, RefusesWithLineAndRemedy) {
  const std::string head = "@<TRIPOS>MOLECULE\nx\n2\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n";
  const std::string one = "1 C1 1 2 3 C.3 1 LIG1\n", two = "2 O1 4 5 6 O.3 1 LIG1\n";
  const struct {
    std::string text;
    std::size_t line;
    const char *reason, *remedy;
  } cases[] = {
      {"@<TRIPOS>ATOM\n" + one, 1, "before any", "beginning"},
      {"@<TRIPOS>MOLECULE\nx\nmany\n", 3, "found \"many\"", "number of atoms"},
      {"@<TRIPOS>MOLECULE\nx\n99999999999999999999999\n", 3, "number of atoms", "name"},
      {"@<TRIPOS>MOLECULE\nx\n1000000000\n@<TRIPOS>ATOM\n" + one, 3, "but 1 follow", "incomplete"},
      {head + one, 3, "announces 2 atoms, but 1", "incomplete"},
      {head + one + two + "3 N1 7 8 9 N.3\n", 9, "more atoms than the 2", "surplus"},
      {head + one + one, 8, "twice", "anew"},
      {head + one + "2 O1 4 5\n", 8, "for z", "truncated"},
      {head + one + "2 O1 4 5 6\n", 8, "type of the atom", "truncated"},
      {head + one + "2 O1 4 nan 6 O.3\n", 8, "for y", "finite"},
      {head + one + "2 O1 4 1e99 6 O.3\n", 8, "too large", "units"},
      {head + one + "2 O1 4 5 6 O.3 one LIG1\n", 8, "the substructure", "whole number"},
      {head + one + "2 O1 4 5 6 O.3 \\\n 1 LIG1\n", 8, "goes on", "one line"},
      {head + one + two + "@<TRIPOS>BOND\n1 1 3 1\n", 10, "atom 3", "Correct the bond"},
  };
  for (const auto& c : cases) {
    const ReadError error = refusal("a.mol2", c.text);
    EXPECT_EQ(error.line(), c.line) << error.what();
    EXPECT_NE(error.reason().find(c.reason), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find(c.remedy), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("a.mol2"), std::string::npos) << error.what();
  }
}

TEST(ReadMol2, IsRecognisedWhateverItsName) {
  EXPECT_EQ(read_text("a.dat", molecule(1, "1 C1 1 2 3 C.3\n")).format, "MOL2");
  EXPECT_EQ(read_text("a.pdb", molecule(1, "1 C1 1 2 3 C.3\n")).format, "MOL2");
}

}  // namespace
}  // namespace alphascope
