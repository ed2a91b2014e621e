// SPDX-License-Identifier: GPL-3.0-or-later
// Tests GRO, the coordinates of GROMACS.
#include <cstdio>
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// An atom line with GROMACS' columns.
std::string atom(int residue, const char* name, const char* atom_name, const std::string& rest) {
  char text[64];
  std::snprintf(text, sizeof text, "%5d%-5s%5s%5d", residue, name, atom_name, 1);
  return text + rest + "\n";
}

const std::string kBox = "   1.86824   1.86824   1.86824\n";

TEST(ReadGro, NanometresBecomeAngstromExactly) {
  const Molecule m = read_text(
      "a.gro", "Water, t= 0.0\n    3\n" + atom(1, "SOL", "OW", "   0.126  -1.624 100.679") +
                   atom(1, "SOL", "HW1", "   0.190   1.661   1.747  0.1227 -0.0580  0.0434") +
                   atom(1, "SOL", "HW2", "   0.000   1.568   1.613") + kBox);
  EXPECT_EQ(m.format, "GRO");
  EXPECT_EQ(m.title, "Water, t= 0.0");
  ASSERT_EQ(m.atoms.size(), 3u);
  EXPECT_EQ(m.lattice.digits, 3);
  EXPECT_EQ(m.rounding_angstrom, 0);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{1260, -16240, 1006790}));
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{1900, 16610, 17470}));
  EXPECT_EQ(m.atoms[2].position.x, 0);
  EXPECT_EQ(m.models.size(), 1u);
}

TEST(ReadGro, ColumnsAreAsWideAsTheDistanceOfTheDecimalPoints) {
  const Molecule m =
      read_text("a.gro", "T\n2\n" + atom(1, "LIG", "C1", "   0.12345  -1.62401   1.67900") +
                             atom(1, "LIG", "O1", "-123.12345-123.12345-123.12345") + kBox);
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.lattice.digits, 4);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{12345, -162401, 167900}));
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{-12312345, -12312345, -12312345}));
  const Molecule two = read_text("a.gro", "T\n1\n" + atom(1, "LIG", "C1", "   0.12   1.62   1.67"));
  EXPECT_EQ(two.atoms[0].position, (LatticePoint{1200, 16200, 16700}));
}

TEST(ReadGro, NamesTellElementsAndResidues) {
  const Molecule m =
      read_text("a.gro", "Solvated\n    9\n" + atom(1, "ALA", "N", "   0.000   0.000   0.000") +
                             atom(1, "ALA", "CA", "   0.146   0.000   0.000") +
                             atom(1, "ALA", "C", "   0.200   0.140   0.000") +
                             atom(1, "ALA", "O", "   0.130   0.240   0.000") +
                             atom(2, "LIG", "C1", "   1.000   1.000   1.000") +
                             atom(3, "NA", "NA", "   2.000   2.000   2.000") +
                             atom(99999, "SOL", "OW", "   3.000   3.000   3.000") +
                             atom(0, "SOL", "OW", "   4.000   3.000   3.000") +
                             atom(0, "SOL", "MW", "   4.010   3.000   3.000") + kBox);
  ASSERT_EQ(m.atoms.size(), 9u);
  const Element elements[] = {7, 6, 6, 8, 6, 11, 8, 8, kUnknownElement};
  const ResidueKind kinds[] = {ResidueKind::polymer, ResidueKind::polymer, ResidueKind::polymer,
                               ResidueKind::polymer, ResidueKind::ligand,  ResidueKind::ion,
                               ResidueKind::water,   ResidueKind::water,   ResidueKind::dummy};
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_EQ(m.atoms[k].element, elements[k]) << k;
    EXPECT_EQ(m.atoms[k].kind, kinds[k]) << k;
  }
  EXPECT_EQ(m.text(m.atoms[1].residue_name), "ALA");
  EXPECT_EQ(m.text(m.atoms[1].name), "CA");
  EXPECT_EQ(m.atoms[6].residue_number, 99999);
  std::string notes;
  for (const std::string& note : m.notes) notes += note + "\n";
  EXPECT_NE(notes.find("Elements guessed from atom names, because GRO files hold none: 8 of 9"),
            std::string::npos)
      << notes;
}

TEST(ReadGro, FramesBecomeModels) {
  const std::string one = "    1\n" + atom(1, "LIG", "C1", "   0.100   0.200   0.300") + kBox;
  const std::string fine = "    1\n" + atom(1, "LIG", "C1", "   0.1000   0.2000   0.3005") +
                           "   1.86824   1.86824   1.86824   0.00000   0.00000   0.62275   0.00000 "
                           "  0.62275   0.62275\n";
  const Molecule m = read_text("a.gro", "first\n" + one + "\n" + fine + "third\n" + one + "\n\n");
  ASSERT_EQ(m.models.size(), 3u);
  EXPECT_EQ(m.title, "first");
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{1000, 2000, 3000}));
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{1000, 2000, 3005}));
}

TEST(ReadGro, IsRecognisedWhateverItsNameAndTitle) {
  const std::string text = "    1\n" + atom(1, "SOL", "OW", "   0.126   1.624   1.679") + kBox;
  for (const char* title : {"Water", "", "solid water", "12", "REMARK of a friend", "# nothing"}) {
    EXPECT_EQ(read_text("a.dat", std::string(title) + "\n" + text).format, "GRO") << title;
  }
  EXPECT_EQ(read_text("a.pdb", "Water\n" + text).format, "GRO");
}

TEST(ReadGro, RefusesWithLineAndRemedy) {
  const std::string good = atom(1, "SOL", "OW", "   0.126   1.624   1.679");
  const struct {
    std::string text;
    std::size_t line;
    const char *reason, *remedy;
  } cases[] = {
      {"Water\n", 1, "the number of atoms", "second line"},
      {"Water\nmany\n" + good, 2, "found \"many\"", "second line"},
      {"Water\n-1\n" + good, 2, "found \"-1\"", "second line"},
      {"Water\n99999999999999999999999\n" + good, 2, "the number of atoms", "second line"},
      {"Water\n1000000000\n" + good + kBox, 4, "residue number", "count"},
      {"Water\n2\n" + good, 3, "after 1 of the 2", "correct the count"},
      {"Water\n2\n" + good + good.substr(0, 35) + "\n", 4, "z is missing", "truncated"},
      {"Water\n1\n" + good + good, 4, "expected the box", "line 2"},
      {"Water\n1\n" + atom(1, "SOL", "OW", "     nan   1.624   1.679"), 3, "decimal points", "gmx"},
      {"Water\n2\n" + good + atom(1, "SOL", "OW", "   0.126     nan   1.679"), 4, "for y",
       "finite"},
      {"Water\n2\n" + good + atom(1, "SOL", "OW", "   0.1269   1.6249   1.6799"), 4,
       "columns 29-36", "gmx editconf"},
      {"Water\n2\n" + good + atom(1, "SOL", "OW", "   0.126   1.624   1.6799"), 4, "columns 37-44",
       "gmx editconf"},
      {"Water\n2\n" + good + atom(1, "SOL", "OW", "   0.126   1e999   1.679"), 4, "too large",
       "units"},
      {"Water\n1\n    XSOL     OW    1   0.126   1.624   1.679\n", 3, "residue number", "columns"},
  };
  for (const auto& c : cases) {
    const ReadError error = refusal("a.gro", c.text);
    EXPECT_EQ(error.line(), c.line) << error.what();
    EXPECT_NE(error.reason().find(c.reason), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find(c.remedy), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("a.gro"), std::string::npos) << error.what();
  }
}

TEST(ReadGro, NumbersOfALargeBoxTouch) {
  const std::string one = "Water\n1\n" + atom(1, "SOL", "OW", "   0.126   1.624   1.679");
  EXPECT_EQ(read_text("a.gro", one + "40000.0000040000.0000040000.00000\n").atoms.size(), 1u);
  EXPECT_NE(refusal("a.gro", one + "40000.0000040000.00000\n").reason().find("the box"),
            std::string::npos);
}

TEST(ReadGro, AMissingBoxIsSaid) {
  const Molecule m =
      read_text("a.gro", "Water\n1\n" + atom(1, "SOL", "OW", "   0.126   1.624   1.679"));
  ASSERT_FALSE(m.notes.empty());
  EXPECT_NE(m.notes.front().find("no line with its box"), std::string::npos) << m.notes.front();
}

}  // namespace
}  // namespace alphascope
