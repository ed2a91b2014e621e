// SPDX-License-Identifier: GPL-3.0-or-later
// Tests PDB files.
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kSmall =
    "TITLE     A SMALL\n"
    "TITLE    2  TEST\n"
    "MODRES 1ABC XYZ A    2  ALA\n"
    "ATOM      1  N   MET A   1      27.340  24.430   2.614  1.00  9.67           N  \n"
    "ATOM      2  CA AMET A   1      26.266  25.413   2.842  0.40 10.38           C  \n"
    "ATOM      3  CA BMET A   1      26.266  25.413  -2.842  0.60 10.38           C  \n"
    "HETATM    4  CB  XYZ A   2      26.266  25.413   8.842  1.00 10.38           C  \n"
    "HETATM    5 ZN    ZN A   3       1.266  25.413   8.842  1.00 10.38          ZN  \n"
    "HETATM    6  C1  LIG A   4       2.266  25.413   8.842  1.00 10.38           C  \n"
    "HETATM    7  O   HOH A   5A      3.266  25.413   8.842  1.00 10.38           O  \n";

TEST(ReadPdb, ReadsColumnsAndKinds) {
  const Molecule m = read_text("a.pdb", kSmall);
  ASSERT_EQ(m.atoms.size(), 7u);
  EXPECT_EQ(m.format, "PDB");
  EXPECT_EQ(m.title, "A SMALL  TEST");
  EXPECT_EQ(m.lattice.digits, 3);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{27340, 24430, 2614}));
  EXPECT_EQ(m.atoms[1].altloc, 'A');
  EXPECT_FLOAT_EQ(m.atoms[2].occupancy, 0.6f);
  EXPECT_EQ(m.atoms[3].kind, ResidueKind::polymer) << "MODRES names it";
  EXPECT_EQ(m.atoms[4].kind, ResidueKind::ion);
  EXPECT_EQ(m.atoms[4].element, 30);
  EXPECT_EQ(m.atoms[5].kind, ResidueKind::ligand);
  EXPECT_EQ(m.atoms[6].kind, ResidueKind::water);
  EXPECT_EQ(m.atoms[6].insertion_code, 'A');
  EXPECT_EQ(m.atoms[6].source_line, 10u);
  EXPECT_EQ(atom_label(m, 1), "CA (A) MET 1, chain A");
  EXPECT_TRUE(m.notes.empty());
}

TEST(ReadPdb, KnownLigandsAreLigandsWhateverTheRecord) {
  const std::string rest = "      27.340  24.430   2.614  1.00  9.67           C  \n";
  const Molecule m =
      read_text("a.pdb",
                "MODRES      SUL A    3  SO4\nMODRES      MSE A    4  MET\n"
                "ATOM      1  CHA HEM A   1 " +
                    rest.substr(1) + "ATOM      2  CA  UNK A   2 " + rest.substr(1) +
                    "HETATM    3  S   SUL A   3 " + rest.substr(1) + "HETATM    4  CA  MSE A   4 " +
                    rest.substr(1) + "ATOM      5  C1  GOL A   5 " + rest.substr(1));
  const ResidueKind expected[] = {ResidueKind::ligand, ResidueKind::polymer, ResidueKind::ligand,
                                  ResidueKind::polymer, ResidueKind::ligand};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(m.atoms[i].kind, expected[i]) << i;
}

TEST(ReadPdb, DefaultSelectionIsCountedInFull) {
  const Molecule m = read_text("a.pdb", kSmall);
  const PreparedBalls prepared = prepare_balls(m);
  EXPECT_EQ(prepared.atom_of_ball, (std::vector<std::uint32_t>{0, 2, 3, 4, 5}));
  EXPECT_EQ(prepared.balls->radii, (std::vector<std::int32_t>{1640, 1880, 1760, 740, 1760}));
  EXPECT_EQ(summary(prepared.report),
            "used 5 of 7 atoms; dropped 1 water, 1 alternative location; radii ProtOr; 3 guessed");
  BallOptions options;
  options.ions = options.ligands = false;
  options.waters = true;
  options.altlocs = AltlocRule::all;
  EXPECT_EQ(prepare_balls(m, options).atom_of_ball, (std::vector<std::uint32_t>{0, 1, 2, 3, 6}));
  options.chains = {"B"};
  EXPECT_EQ(prepare_balls(m, options).balls->size(), 0u);
  options.model = 3;
  EXPECT_THROW(prepare_balls(m, options), std::invalid_argument);
}

TEST(ReadPdb, RefusesBrokenColumnsWithTheLine) {
  const std::string good =
      "ATOM      1  N   MET A   1      27.340  24.430   2.614  1.00  9.67           N  \n";
  const ReadError bad =
      refusal("a.pdb", good + "ATOM      2  CA  MET A   1      27.340  24.x30   2.614\n");
  EXPECT_EQ(bad.line(), 2u);
  EXPECT_EQ(bad.reason(), "expected y in columns 39-46, found \"  24.x30\"");
  const ReadError shifted = refusal(
      "a.pdb", good + "ATOM      2  CA  MET A   123456270.340  24.430   2.614  oops  9.67\n");
  EXPECT_EQ(shifted.reason().find("the occupancy in columns 55-60 is not a number: \"  oops\""), 0u)
      << shifted.reason();
  const ReadError cut = refusal("a.pdb", good + "ATOM      2  CA  MET A   1      27.340\n");
  EXPECT_EQ(cut.reason(), "y is missing: columns 39-46 are empty");
  const ReadError end = refusal("a.pdb", good + good.substr(0, 52));
  EXPECT_EQ(end.reason(), "the file ends within this atom") << "z would lose digits";
  EXPECT_EQ(end.line(), 2u);
  EXPECT_EQ(
      refusal("a.pdb", good + "ATOM      2  CA  MET A   1         nan  24.430   2.614\n").line(),
      2u);
  EXPECT_NE(refusal("a.pdb", "HEADER    NOTHING\nEND\n").reason().find("no atoms"),
            std::string::npos);
  EXPECT_NE(refusal("a.pdb", "").reason().find("no atoms"), std::string::npos);
}

TEST(ReadPdb, FiveDigitResidueNumbersPushTheColumns) {
  const Molecule m = read_text(
      "a.pdb",
      "ATOM  42326   OW SOL   9999      14.195  58.650 112.800  1.00  0.00           O  \n"
      "ATOM  42327   OW SOL  10000      14.195  58.650 112.800  1.00  0.00           O  \n"
      "ATOM  42328   OW SOL  10000    -114.1951058.650-112.800  1.00  0.00           O  \n");
  EXPECT_EQ(m.atoms[0].residue_number, 9999);
  EXPECT_EQ(m.atoms[1].residue_number, 10000);
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{14195, 58650, 112800}));
  EXPECT_EQ(m.atoms[2].position, (LatticePoint{-114195, 1058650, -112800}));
  EXPECT_EQ(m.atoms[1].element, 8);
  EXPECT_EQ(m.notes.size(), 1u);
}

TEST(ReadPdb, HybridThirtySix) {
  const std::string rest = "      27.340  24.430   2.614\n";
  const Molecule m = read_text("a.pdb", "ATOM  99999  N   MET A9999 " + rest.substr(1) +
                                            "ATOM  A0000  N   MET AA000 " + rest.substr(1) +
                                            "ATOM  a0000  N   MET Aa000 " + rest.substr(1) +
                                            "ATOM  *****  N   MET A  -1 " + rest.substr(1));
  EXPECT_EQ(m.atoms[0].serial, 99999);
  EXPECT_EQ(m.atoms[1].serial, 100000);
  EXPECT_EQ(m.atoms[1].residue_number, 10000);
  EXPECT_EQ(m.atoms[2].serial, 100000 + 26 * 36 * 36 * 36 * 36);
  EXPECT_EQ(m.atoms[3].serial, 0);
  EXPECT_EQ(m.atoms[3].residue_number, -1);
  const Molecule six = read_text("a.pdb", "ATOM 111757  CG3 VAL B  52 " + rest.substr(1));
  EXPECT_EQ(six.atoms[0].serial, 111757);
}

TEST(ReadPdb, Models) {
  const std::string atom = "ATOM      1  N   MET A   1      27.340  24.430   2.614\n";
  const Molecule m = read_text("a.pdb", "MODEL        4\n" + atom + atom +
                                            "ENDMDL\nMODEL        5\nENDMDL\n" + atom + "END\n");
  ASSERT_EQ(m.models.size(), 2u);
  EXPECT_EQ(m.models[0].number, 4);
  EXPECT_EQ(m.models[0].size(), 2u);
  EXPECT_EQ(m.models[1].size(), 1u);
  const Molecule before = read_text("a.pdb", atom + "ENDMDL\n" + atom + atom + "MODEL 7\n" + atom);
  ASSERT_EQ(before.models.size(), 3u) << "atoms before any MODEL are a model";
  EXPECT_EQ(before.models[0].size(), 1u);
  EXPECT_EQ(before.models[1].number, 2);
  EXPECT_EQ(before.models[1].size(), 2u);
  EXPECT_EQ(before.models[2].number, 7);
  BallOptions all;
  all.model = kAllModels;
  EXPECT_EQ(prepare_balls(m, all).report.used, 3u);
  EXPECT_EQ(prepare_balls(m, all).report.coincident_centres, 2u);
}

TEST(ReadPdb, ReadsTheChaperonin) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule m = read_molecule(test_data("thesis/1aon.pdb.gz"));
  std::size_t hetero = 0;
  for (const Atom& a : m.atoms) hetero += a.hetero;
  EXPECT_EQ(m.atoms.size() - hetero, 58674u);
  EXPECT_EQ(hetero, 196u);
  EXPECT_EQ(m.models.size(), 1u);
}

std::string water(int number, char altloc, const char* segment) {
  char line[100];
  std::snprintf(
      line, sizeof line, "HETATM%5d  O  %cHOH W%4d    %8.3f%8.3f%8.3f  %4.2f 10.00      %-4s O\n",
      number % 100000, altloc, number % 10000, number % 100 * 3.0, number / 100 % 100 * 3.0,
      number / 10000 * 3.0 + (altloc == 'B' ? 1 : 0), altloc == ' ' ? 1.0 : 0.5, segment);
  return line;
}

BallOptions with_waters() {
  BallOptions options;
  options.waters = true;
  return options;
}

TEST(ReadPdb, WatersThatShareAWrappedNumberAreAllKept) {
  std::string text;
  for (int number = 1; number <= 25'000; ++number) {
    if (number % 1000 != 7) {
      text += water(number, ' ', "");
    } else if (number < 20'000) {  // a pair of locations in the first two rounds
      text += water(number, 'A', "") + water(number, 'B', "");
    } else {  // one letter only
      text += water(number, 'B', "");
    }
  }
  const PreparedBalls prepared = prepare_balls(read_text("a.pdb", text), with_waters());
  EXPECT_EQ(prepared.report.used, 25'000u);
  EXPECT_EQ(prepared.report.dropped_altlocs, 20u);
  EXPECT_EQ(prepared.report.dropped.size(), 1u);
  EXPECT_EQ(prepared.report.dropped[0].residue, "HOH");
}

TEST(ReadPdb, SegmentsTellResiduesOfOneNumberApart) {
  const std::string text =
      water(1, 'A', "WT1") + water(1, 'B', "WT1") + water(1, ' ', "WT2") + water(1, 'C', "WT3");
  EXPECT_EQ(prepare_balls(read_text("a.pdb", text), with_waters()).report.used, 3u);
  const Molecule m = read_text("a.pdb", text);
  EXPECT_EQ(m.atoms[0].segment, m.atoms[1].segment);
  EXPECT_NE(m.atoms[1].segment, m.atoms[2].segment);
  // PDBQT has charges in these columns.
  const std::string charges = water(1, 'A', " 0.1") + water(1, 'B', " 0.2");
  EXPECT_EQ(prepare_balls(read_text("a.pdb", charges), with_waters()).report.used, 1u);
}

TEST(ReadPdb, LocationsCompeteAmongWhatIsSelected) {
  const std::string text = water(1, 'A', "") + water(1, 'B', "") + water(2, ' ', "");
  BallOptions options = with_waters();
  EXPECT_EQ(prepare_balls(read_text("a.pdb", text), options).atom_of_ball,
            (std::vector<std::uint32_t>{0, 2}));
  options.selection = "altloc B";
  EXPECT_EQ(prepare_balls(read_text("a.pdb", text), options).atom_of_ball,
            (std::vector<std::uint32_t>{1}));
  options.selection = "not altloc A";
  EXPECT_EQ(prepare_balls(read_text("a.pdb", text), options).atom_of_ball,
            (std::vector<std::uint32_t>{1, 2}));
  options.selection = "altloc C";
  EXPECT_EQ(prepare_balls(read_text("a.pdb", text), options).report.used, 0u);
}

}  // namespace
}  // namespace alphascope
