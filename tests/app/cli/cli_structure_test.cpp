// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what `info` says about secondary structure and bonds, as text and as JSON.
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

using CliStructure = Cli;

// Two bound glycines without records, beside a ligand of two atoms.
constexpr const char* kWithoutRecords =
    "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 10.00           N\n"
    "ATOM      2  CA  GLY A   1       1.200   0.800   0.000  1.00 10.00           C\n"
    "ATOM      3  C   GLY A   1       2.470   0.000   0.000  1.00 10.00           C\n"
    "ATOM      4  O   GLY A   1       2.470  -1.200   0.000  1.00 10.00           O\n"
    "ATOM      5  N   GLY A   2       3.800   0.000   0.000  1.00 10.00           N\n"
    "ATOM      6  CA  GLY A   2       5.000   0.800   0.000  1.00 10.00           C\n"
    "ATOM      7  C   GLY A   2       6.270   0.000   0.000  1.00 10.00           C\n"
    "ATOM      8  O   GLY A   2       6.270  -1.200   0.000  1.00 10.00           O\n"
    "HETATM    9  C1  LQ9 A 301       0.000  20.000   0.000  1.00 10.00           C\n"
    "HETATM   10  O2  LQ9 A 301       1.400  20.000   0.000  1.00 10.00           O\n"
    "END\n";

TEST_F(CliStructure, InfoCountsThatOfCrambin) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb'";
  const Outcome text = run("info " + file);
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "2 helices (2 alpha), 2 strands; from the file's records"))
      << text.out;
  EXPECT_TRUE(contains(text.out,
                       "337 bonds: 3 from the file, 289 of known residues, 45 between neighbours "
                       "in a chain; 0 guessed by distance"))
      << text.out;
  const json all = json::parse(run("info " + file + " --each-residue --json -").out);
  EXPECT_EQ(all["secondary_structure"]["source"], "file");
  EXPECT_EQ(all["secondary_structure"]["kinds"]["alpha_helix"]["stretches"], 2);
  EXPECT_EQ(all["bonds"]["from_file"], 3) << "its disulphides";
  EXPECT_EQ(all["bonds"]["guessed"], 0);
}

TEST_F(CliStructure, WithoutRecordsHydrogenBondsAndDistancesDecide) {
  const std::string file = "'" + write("without.pdb", kWithoutRecords).string() + "'";
  const json all = json::parse(run("info " + file + " --json -").out);
  EXPECT_EQ(all["secondary_structure"]["source"], "hydrogen_bonds");
  EXPECT_EQ(all["secondary_structure"]["kinds"]["coil"]["residues"], 2);
  const json& bonds = all["bonds"];
  EXPECT_EQ(bonds["bonds"], 8);
  EXPECT_EQ(bonds["of_known_residues"], 6);
  EXPECT_EQ(bonds["between_neighbours"], 1);
  EXPECT_EQ(bonds["guessed"], 1) << "the ligand's";
}

}  // namespace
}  // namespace alphascope::testing
