// SPDX-License-Identifier: GPL-3.0-or-later
// Tests residues in alphascope-cli: what they are, why, and a user's treatments.
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

// Two bound amino acids. Then a ligand of two atoms, an ion, a water and a dummy, by their records
// and names. The last atom is of an unknown residue, whose kind is guessed.
constexpr const char* kOfEachKind =
    "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 10.00           N\n"
    "ATOM      2  CA  GLY A   1       1.200   0.800   0.000  1.00 10.00           C\n"
    "ATOM      3  C   GLY A   1       2.470   0.000   0.000  1.00 10.00           C\n"
    "ATOM      4  O   GLY A   1       2.470  -1.200   0.000  1.00 10.00           O\n"
    "ATOM      5  N   ALA A   2       3.800   0.000   0.000  1.00 10.00           N\n"
    "ATOM      6  CA  ALA A   2       5.000   0.800   0.000  1.00 10.00           C\n"
    "ATOM      7  C   ALA A   2       6.270   0.000   0.000  1.00 10.00           C\n"
    "ATOM      8  O   ALA A   2       6.270  -1.200   0.000  1.00 10.00           O\n"
    "HETATM    9  C1  LQ9 A 301       0.000  20.000   0.000  1.00 10.00           C\n"
    "HETATM   10  O2  LQ9 A 301       1.400  20.000   0.000  1.00 10.00           O\n"
    "HETATM   11 ZN    ZN A 302       0.000  30.000   0.000  1.00 10.00          ZN\n"
    "HETATM   12  O   HOH A 303       0.000  40.000   0.000  1.00 10.00           O\n"
    "HETATM   13  N1  DUM A 304       0.000  50.000   0.000  1.00 10.00           N\n"
    "ATOM     14  C1  QIG A 305       0.000  60.000   0.000  1.00 10.00           C\n"
    "END\n";

class CliResidues : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    file_ = "'" + write("kinds.pdb", kOfEachKind).string() + "' ";
  }
  json info(const std::string& more) const {
    const Outcome outcome = run("info " + file_ + more + " --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
  // Lines such as "LQ9 301 ligand hetatm 1 2".
  static std::vector<std::string> lines(const json& residues) {
    std::vector<std::string> list;
    for (const json& r : residues) {
      list.push_back(r["name"].get<std::string>() + " " + r["number"].get<std::string>() + " " +
                     r["kind"].get<std::string>() + " " + r["why"].get<std::string>() + " " +
                     std::to_string(r["residues"].get<int>()) + " " +
                     std::to_string(r["atoms"].get<int>()));
      EXPECT_EQ(r["chain"], "A");
      EXPECT_EQ(r["guessed"], r["why"] == "no_polymer");
      EXPECT_FALSE(r["text"].get<std::string>().empty());
    }
    return list;
  }
  std::string file_;
};

TEST_F(CliResidues, AreListedWithKindAndReason) {
  using Lines = std::vector<std::string>;
  const Lines others{"LQ9 301 ligand hetatm 1 2", "ZN 302 ion ion_name 1 1",
                     "HOH 303 water water_name 1 1", "DUM 304 dummy dummy_name 1 1",
                     "QIG 305 ligand no_polymer 1 1"};
  Lines grouped{" 1-2 polymer chain_bond 2 8"};
  Lines each{"GLY 1 polymer chain_bond 1 4", "ALA 2 polymer chain_bond 1 4"};
  grouped.insert(grouped.end(), others.begin(), others.end());
  each.insert(each.end(), others.begin(), others.end());
  const json report = info("--residues");
  EXPECT_EQ(lines(report["residues"]), grouped);
  EXPECT_EQ(lines(info("--each-residue")["residues"]), each);
  EXPECT_EQ(report["kinds"],
            json::parse(R"({"polymer": 8, "water": 1, "ligand": 3, "ion": 1, "dummy": 1})"));
  EXPECT_FALSE(info("").contains("residues")) << "only when they are asked for";
}

TEST_F(CliResidues, AreListedForPeople) {
  const Outcome grouped = run("info " + file_ + "--residues");
  EXPECT_EQ(grouped.code, 0) << grouped.err;
  EXPECT_TRUE(contains(grouped.out, "A            1-2     polymer         2          8  bound to"))
      << grouped.out;
  EXPECT_TRUE(contains(grouped.out, "A      LQ9   301     ligand          1          2  HETATM"));
  EXPECT_TRUE(contains(grouped.out, "guess: ATOM, but no amino acid or nucleotide"));
  EXPECT_FALSE(contains(grouped.out, "GLY"));
  const Outcome each = run("info " + file_ + "--each-residue");
  EXPECT_TRUE(contains(each.out, "A      GLY   1       polymer         1          4"));
  EXPECT_TRUE(contains(each.out, "A      ALA   2       polymer         1          4"));
}

TEST_F(CliResidues, AreWhatAUserSays) {
  const json report = info("--residues --treat 'A:LQ9 301=water,QIG=ion'");
  EXPECT_EQ(report["kinds"],
            json::parse(R"({"polymer": 8, "water": 3, "ligand": 0, "ion": 2, "dummy": 1})"));
  const std::vector<std::string> list = lines(report["residues"]);
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[1], "LQ9 301 water by_hand 1 2");
  EXPECT_EQ(list[5], "QIG 305 ion by_hand 1 1");
  // Three atoms of waters and the dummy are left out of 14 atoms.
  EXPECT_EQ(report["input"]["balls"], 10);
  EXPECT_EQ(report["input"]["options"], "--treat 'A:LQ9 301=water' --treat 'QIG=ion'");
  const auto rows = csv_rows(run("info " + file_ + "--treat 'resn LQ9=polymer' --csv -").out);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(contains(rows[0].at("options"), "--treat 'resn LQ9=polymer'"));
  EXPECT_EQ(rows[0].at("balls"), "12");
  // The body of cavities is polymer only.
  const Outcome cavities = run("cavities " + file_ + "--treat LQ9=polymer");
  EXPECT_TRUE(contains(cavities.out, "used 10 of 14 atoms")) << cavities.out << cavities.err;
  EXPECT_TRUE(contains(cavities.out, "kinds of residues are set by hand"));
}

// The file lacks these residues. A note says so and it is no error, since the same treatments may
// be given for many files.
TEST_F(CliResidues, WhatIsNotInTheFileIsSaidAndDoesNoHarm) {
  for (const std::string residues : {"B:XYZ 7", "PU8", "005", "resi 77"}) {
    const json report = info("--treat '" + residues + "=ion'");
    EXPECT_EQ(report["kinds"]["ion"], 1) << residues;
    const json& notes = report["input"]["notes"];
    const std::string note = "Residues to be treated as ion that are not in this file: " + residues;
    EXPECT_NE(std::find(notes.begin(), notes.end(), note), notes.end()) << notes;
  }
}

TEST_F(CliResidues, AWrongKindOrPlaceIsRefusedBeforeAnyFileIsRead) {
  const auto refused = [&](const std::string& treatment, const std::string& what) {
    for (const std::string& file : {file_, std::string("no_such_file.pdb ")}) {
      const Outcome outcome = run("info " + file + "--treat '" + treatment + "'");
      EXPECT_EQ(outcome.code, 2) << treatment;
      EXPECT_TRUE(contains(outcome.err, "--treat")) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, what)) << outcome.err;
      EXPECT_TRUE(outcome.out.empty());
    }
  };
  refused("LQ9=metal", "\"LQ9=metal\" does not say what residues are");
  refused("LQ9=metal", "with polymer, ligand, ion, water or dummy.");
  refused("LQ9", "write them as \"A:PU8 301=ligand\"");
  refused("=ion", "\"=ion\" does not say what residues are");
  refused("resi (=ion", "\"resi (\" names no residues, column 6: expected");
  refused("A:LQ9 x=ion", "\"A:LQ9 x\" names no residues, column 1: ");
  refused("LQ9=ion,QIG=1", "\"QIG=1\" does not say");
  refused("", "the value is empty");
}

// Among reasons for equally many atoms, the first one gets its remedy.
TEST_F(CliResidues, OfEqualReasonsTheFirstHasItsRemedyTold) {
  const std::string atom =
      "HETATM    1  O   HOH A   1      27.340  24.430   2.614  1.00  9.67           O  \n";
  std::string ion = atom;
  ion.replace(12, 8, " ZN   ZN")
      .replace(76, 2, "ZN")
      .replace(25, 1, "2")
      .replace(30, 8, "  17.340");
  const fs::path file = write("two.pdb", ion + atom + "END\n");
  const Outcome outcome = run("info '" + file.string() + "' --no-ions");
  EXPECT_EQ(outcome.code, 2);
  const std::size_t water = outcome.err.find("1 water"), metal = outcome.err.find("1 ion");
  ASSERT_NE(water, std::string::npos) << outcome.err;
  ASSERT_NE(metal, std::string::npos) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, water < metal ? "Add --waters." : "Leave out --no-ions."))
      << outcome.err;
}

TEST_F(CliResidues, NothingLeftIsAnError) {
  const Outcome outcome = run("info " + file_ + "--treat all=water");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "no atom is left")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "Add --waters.")) << outcome.err;
  EXPECT_EQ(run("info " + file_ + "--treat all=water --waters").code, 0);
}

}  // namespace
}  // namespace alphascope::testing
