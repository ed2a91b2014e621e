// SPDX-License-Identifier: GPL-3.0-or-later
// Tests tables of balls.
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

TEST(ReadBalls, SaysOfNumbersWithTooManyDigitsByHowMuchTheyAreRounded) {
  const Molecule m = read_text("a.xyzr", "0.123456789 0 0 1.5\n1 2 3 1.2500004\n");
  EXPECT_EQ(m.lattice.digits, 6);
  EXPECT_EQ(m.atoms.at(0).position.x, 123457);
  EXPECT_EQ(m.atoms.at(1).file_radius, 1250000);
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_NE(
      m.notes[0].find("lattice of 1e-06 Å can hold; they are rounded once, by at most 4e-07 Å"),
      std::string::npos)
      << m.notes[0];
  EXPECT_TRUE(read_text("a.xyzr", "0.123456 0 0 1.5\n").notes.empty());
}

TEST(ReadBallTable, PutsTextOnTheLatticeExactly) {
  const Molecule m =
      read_text("a.xyzr", "# made by hand\n\n0.1 -2.25 3 1.5\n4e0 5 6.00001 1.70000 CA\n");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.format, "XYZR");
  EXPECT_EQ(m.lattice.digits, 5);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{10000, -225000, 300000}));
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{400000, 500000, 600001}));
  EXPECT_EQ(m.atoms[0].file_radius, 150000);
  EXPECT_EQ(m.atoms[0].source_line, 3u);
  EXPECT_EQ(m.text(m.atoms[1].name), "CA");
  EXPECT_EQ(m.atoms[1].element, 6);
  EXPECT_EQ(m.rounding_angstrom, 0);
  EXPECT_TRUE(m.has_file_radii);
}

TEST(ReadBallTable, RoundsOnceWhenTheLatticeIsTooSmallAndSaysSo) {
  const Molecule m = read_text("a.xyzr", "2000.1234567 0 0 1.5\n");
  EXPECT_EQ(m.lattice.digits, 5);
  EXPECT_EQ(m.atoms[0].position.x, 200012346);
  EXPECT_NEAR(m.rounding_angstrom, 0.0000033, 1e-12);
}

TEST(ReadBallTable, KnowsBothCrdDialectsAndLabels) {
  const Molecule counted = read_text("a.crd", "2        \r\n\r\n1\t2\t3\t1.4\r\n4\t5\t6\t1.5\r\n");
  EXPECT_EQ(counted.format, "CRD");
  EXPECT_EQ(counted.atoms.size(), 2u);
  const Molecule bare = read_text("b.crd", " 1 2 3 1.4\n");
  EXPECT_EQ(bare.atoms.size(), 1u);
  const Molecule labelled = read_text("c.xyzr", "A 12 CA 1 2 3 1.4\nB 13 ZN 1 2 4 1.4");
  EXPECT_EQ(read_text("d.xyzr", "c0 1 1 2 3 1.4\nc1 2 -1 2 3 1.5\n").atoms[1].position.x, -1000);
  ASSERT_EQ(labelled.atoms.size(), 2u);
  EXPECT_EQ(labelled.text(labelled.atoms[1].chain), "B");
  EXPECT_EQ(labelled.atoms[1].residue_number, 13);
  EXPECT_EQ(labelled.text(labelled.atoms[1].name), "ZN");
}

TEST(ReadBallTable, RecognisesTheNumbersOfTheBallsAndSaysSo) {
  for (const char* text : {"1 10.0 20.0 30.0 1.5\n2 11.5 -20.0 30.0 1.7 CA\n",
                           "0 10.0 20.0 30.0 1.5\n1 11.5 -20.0 30.0 1.7 CA\n",
                           "2\n1 10 20 -30 1.5\n2 11.5 -20 30 1.7 CA\n"}) {
    SCOPED_TRACE(text);
    const Molecule m = read_text("a.xyzr", text);
    ASSERT_EQ(m.atoms.size(), 2u);
    EXPECT_EQ(m.atoms[0].position.x, 10000);
    EXPECT_EQ(m.atoms[0].file_radius, 1500);
    EXPECT_EQ(m.atoms[1].position, (LatticePoint{11500, -20000, 30000}));
    EXPECT_EQ(m.atoms[1].file_radius, 1700);
    EXPECT_EQ(m.text(m.atoms[1].name), "CA");
    ASSERT_EQ(m.notes.size(), 1u);
    EXPECT_NE(m.notes[0].find("number of the ball"), std::string::npos);
  }
  const std::string many = "1 10.0 20.0 30.0 1.5\n2 11.5 20.0 30.0 1.7\n";
  EXPECT_EQ(refusal("a.xyzr", many + "3 1.5 2.5 3.5\n").line(), 1u);
  EXPECT_EQ(refusal("a.xyzr", many + "3 1.5 2.5 3.5 x\n").line(), 1u);
}

TEST(ReadBallTable, RefusesFiveNumbersOfTwoReadings) {
  for (const char* text :
       {"1 10.0 20.0 30.0 1.5\n", "1 0 0 1 7\n2 0 0 1 7\n",
        "5 1.0 2.0 3.0 1.5\n9 1.5 2.0 3.0 1.5\n", "1 10.0 20.0 30.0 1 CA\n2 10.0 20.0 31.0 1 CB\n",
        "1\n\n1 10.0 20.0 30.0 1.5\n"}) {
    SCOPED_TRACE(text);
    const ReadError error = refusal("a.crd", text);
    EXPECT_NE(error.reason().find("five numbers"), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST(ReadBallTable, NumbersBehindTheRadiusAreSaid) {
  const Molecule m = read_text("a.xyzr", "0.5 1 2 1.5 7\n1 1 2 1.5\n-1 1 2 1.7 7.5 8\n");
  ASSERT_EQ(m.atoms.size(), 3u);
  EXPECT_EQ(m.atoms[2].file_radius, 1700);
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_NE(m.notes[0].find("in 2 of 3 lines, first in line 1"), std::string::npos) << m.notes[0];
  // MSMS' flag and name, names, and comments with a mark are no surplus.
  const Molecule named =
      read_text("a.xyzr", "1 2 3 1.7 1 CA_ALA_12\n2 2 3 1.7 1 CD_CD_13\n3 1.0 2.0 1.5 1 C_LIG_2\n");
  EXPECT_TRUE(named.notes.empty());
  EXPECT_EQ(named.atoms[0].position.x, 1000);
  EXPECT_EQ(named.atoms[0].element, 6);
  EXPECT_EQ(named.atoms[1].element, 48);
  EXPECT_TRUE(read_text("a.xyzr", "1 2 3 1.7 # 4 5\n").notes.empty());
}

TEST(ReadBallTable, LabelsAreTheSameInEveryLine) {
  const ReadError more = refusal("a.xyzr", "A 1 2 3 1.5\nB 12 1 2 3 1.5\n");
  EXPECT_EQ(more.line(), 2u);
  EXPECT_EQ(more.reason(), "the line has 6 fields, the first ball's has 5");
  EXPECT_EQ(refusal("a.xyzr", "A 1.5 2.5 3.5 1.5 7\n").line(), 1u);
  EXPECT_EQ(refusal("a.xyzr", "A 1 2 3 1.5 7 8\n").line(), 1u);
  EXPECT_EQ(read_text("a.xyzr", "A -1 CA 1 2 3 1.5 # 7\n").atoms[0].residue_number, -1);
}

TEST(ReadBallTable, NamesLineAndRemedyOfWhatIsWrong) {
  EXPECT_STREQ(refusal("a.xyzr", "1 2 3 1.5\n1 2 3 -0.5\n").reason().c_str(),
               "the radius is negative");
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1.5\n1 2 3 -0.5\n").line(), 2u);
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1.5\n1 2 nan 1\n").reason(),
            "expected a number for z, found \"nan\"");
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1.5\n1 2 3\n").reason(), "the line ends before r");
  const ReadError few = refusal("a.crd", "3\n\n1 2 3 1.5\n");
  EXPECT_EQ(few.line(), 1u);
  EXPECT_EQ(few.reason(), "the first line announces 3 balls, but 1 follow");
  EXPECT_EQ(refusal("a.crd", "1\n\n1 2 3 1.5\n1 2 4 1.5\n").line(), 4u);
  const ReadError huge = refusal("a.xyzr", "1 2 3 1.5\n1e300 2 3 1\n");
  EXPECT_EQ(huge.line(), 2u);
  EXPECT_NE(huge.reason().find("too large"), std::string::npos) << huge.what();
  // The largest coordinate that fits on a lattice of whole ångströms, and the next one.
  EXPECT_EQ(read_text("a.xyzr", "536870911 0 0 1\n").atoms.at(0).position.x, 536870911);
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1\n0 -536870912 0 1\n").line(), 2u);
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1\n0 0 0 67108864\n").line(), 2u);
  EXPECT_NE(refusal("a.xyzr", "1 2 3 1e-30\n1e5 2 3 1\n").reason().find("too small"),
            std::string::npos);
}

TEST(ReadBallTable, ZeroRadiusIsDroppedAndCounted) {
  const Molecule m = read_text("a.xyzr", "1 2 3 0\n1 2 4 1.5\n");
  const PreparedBalls prepared = prepare_balls(m);
  EXPECT_EQ(prepared.balls->size(), 1u);
  EXPECT_EQ(prepared.report.dropped_zero_radius, 1u);
  EXPECT_EQ(prepared.atom_of_ball, std::vector<std::uint32_t>{1});
  EXPECT_EQ(summary(prepared.report),
            "used 1 of 2 atoms; dropped 1 atom of radius 0; radii from the file");
}

TEST(ReadBallTable, ReadsTheThesisFiles) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule kcsa = read_molecule(test_data("thesis/1k4c.crd.gz"));
  EXPECT_EQ(kcsa.atoms.size(), 16068u);
  EXPECT_EQ(kcsa.lattice.digits, 4);
  EXPECT_EQ(kcsa.atoms[1].position, (LatticePoint{1247216, 1215087, -212039}));
  EXPECT_EQ(kcsa.atoms[1].file_radius, 15480);
  EXPECT_EQ(prepare_balls(kcsa).balls->size(), 16068u);
  EXPECT_EQ(read_molecule(test_data("ladder/1grm.crd")).atoms.size(), 260u);
  EXPECT_EQ(read_molecule(test_data("awkward/1a8o.xyzr")).atoms.size(), 644u);
}

TEST(ReadMolecule, NamesWhatIsNoOrdinaryFile) {
  const TemporaryFile file("a.pdb", "");
  try {
    read_molecule(file.path().parent_path());
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_EQ(error.reason(), "this is a folder, not a file");
  }
  try {
    read_molecule(file.path().parent_path() / "none.pdb");
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_EQ(error.reason(), "there is no such file");
    EXPECT_NE(std::string(error.what()).find("none.pdb"), std::string::npos);
  }
  EXPECT_NE(refusal("a.txt", "Dear reader,\nhello").reason().find("Dear reader"),
            std::string::npos);
  ReadOptions small;
  small.max_bytes = 100;
  EXPECT_NE(refusal("a.xyzr", std::string(1000, '\n'), small).reason().find("limit"),
            std::string::npos);
}

}  // namespace
}  // namespace alphascope
