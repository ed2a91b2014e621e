// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli explain on small files: sentences, JSON, and messages for wrong simplices.
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

class CliExplain : public Cli {
 protected:
  json explained(const std::string& arguments) const {
    const Outcome outcome = run("explain " + arguments + " --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
};

// An edge of the cube of balls with radius 1.5. Its middle is 1 from both centres, so rho = 1 -
// 2.25.
TEST_F(CliExplain, SaysWhatAnEdgeIs) {
  const std::string edge = "'" + cube_.string() + "' --simplex 1,0 --alpha -1";
  const json e = explained(edge);
  EXPECT_EQ(e["simplex"], json({0, 1}));
  EXPECT_TRUE(e["in_triangulation"]);
  EXPECT_EQ(e["orthosphere"]["centre_angstrom"], json({1.0, 0.0, 0.0}));
  EXPECT_EQ(e["orthosphere"]["rho_angstrom2"], -1.25);
  EXPECT_EQ(e["orthosphere"]["rho_sign"], -1);
  EXPECT_FALSE(e["attached"]);
  EXPECT_EQ(e["appears"]["alpha_angstrom2"], -1.25);
  EXPECT_EQ(e["appears"]["from"], e["simplex"]);
  EXPECT_EQ(e["regular"]["alpha_angstrom2"], -0.25);  // triangles of the faces, with ties
  EXPECT_TRUE(e["interior"].is_null());               // an edge of the hull
  EXPECT_EQ(e["at_alpha"]["in_complex"], true);
  EXPECT_EQ(e["at_alpha"]["class"], "singular");
  EXPECT_EQ(e["nearest"][0]["power_angstrom2"], 2.75);  // 1 + 4 - 2.25
  EXPECT_EQ(e["nearest"][0]["margin_angstrom2"], 4);
  const std::string text = run("explain " + edge).out;
  for (const char* part :
       {"It is in the alpha complex at alpha = -1 Å²", "singular", "(1.000, 0.000, 0.000) Å",
        "ρ = -1.25 Å²", "the orthosphere is imaginary", "the margin 4 Å²",
        "It never becomes interior"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
}

TEST_F(CliExplain, SaysHowLongItTookUnlessTimesAreNotWanted) {
  const std::string edge = "'" + cube_.string() + "' --simplex 1,0";
  EXPECT_TRUE(contains(run("explain " + edge).out, "\nTime ")) << run("explain " + edge).out;
  EXPECT_FALSE(contains(run("explain --no-times " + edge).out, "\nTime "));
}

// rho of the edge is 1.25000150000025 Å², slightly more than alpha. Both are printed with all
// digits.
TEST_F(CliExplain, DoesNotRoundWhatDecides) {
  const std::string file = "'" + write("two.xyzr", "0 0 0 1\n3.000001 0 0 1\n").string() + "'";
  const std::string text =
      run("explain " + file + " --simplex 0,1 --alpha 1.250001500000249999").out;
  std::string words;  // without line breaks
  for (const char c : text) {
    if (c != ' ' && c != '\n') words += c;
  }
  EXPECT_TRUE(contains(words,
                       "Itisnotinthealphacomplexatalpha=1.250001500000249999Å²."
                       "Itsalphavalue,1.25000150000025Å²,islarger."))
      << text;
}

TEST_F(CliExplain, SaysWhatIsNotThere) {
  const std::string cube = "'" + cube_.string() + "'";
  // Four corners of one side. Diagonals of the cube or of a side are there by ties.
  EXPECT_EQ(explained(cube + " --simplex 0,1,2,3")["absence"]["reason"], "dependent");
  const json one = explained(cube + " --simplex 0,3"), other = explained(cube + " --simplex 1,2");
  EXPECT_NE(one["in_triangulation"], other["in_triangulation"]);
  EXPECT_EQ(one["nearest"][0]["margin_angstrom2"], 0);
  EXPECT_EQ(one["nearest"][0]["sign"], 0);
  EXPECT_EQ(one["nearest"][0]["arithmetic"].back()["by"], "perturbation");
  write("hidden.xyzr", "0 0 0 1\n0 0 0 2\n5 0 0 1\n");
  const std::string file = "'" + (folder_ / "hidden.xyzr").string() + "'";
  const json hidden = explained(file + " --simplex 0,2");
  EXPECT_EQ(hidden["absence"]["reason"], "hidden");
  EXPECT_EQ(hidden["absence"]["culprits"], json({1}));
  EXPECT_TRUE(contains(run("explain " + file + " --simplex 0").out,
                       "is hidden. There is no point on the line"));
}

TEST_F(CliExplain, TakesNamesOfAtoms) {
  const json by_name =
      explained("'" + kCrambin + "' --atoms 'A:THR 1:CA,A:THR 1:CB' --solvent 1.4");
  EXPECT_EQ(by_name["simplex"], json({1, 4}));
  EXPECT_EQ(by_name["atoms"], json({"A:THR 1:CA", "A:THR 1:CB"}));
  EXPECT_EQ(by_name["request"]["solvent_radius_angstrom"], 1.4);
}

TEST_F(CliExplain, RefusesWhatIsNoSimplex) {
  const struct {
    const char *options, *said;
  } cases[] = {{"", "give --simplex I,J,K,L or --atoms ATOMS"},
               {"--simplex 1,2,1", "--simplex names ball 1 twice"},
               {"--simplex 0,1,2,3,4", "--simplex has 5 balls; a simplex has 1 to 4"},
               {"--simplex 3,327", "there is no ball 327: 1crn.pdb has 327 balls, 0 to 326."},
               {"--simplex 1,x", "\"x\" is not a whole number"},
               {"--atoms A:", "--atoms names 327 atoms that are balls"},
               {"--atoms 'chain Q'", "--atoms names 0 atoms"},
               {"--simplex 1 --model all", "explain takes one model."}};
  for (const auto& c : cases) {
    const Outcome outcome = run("explain '" + kCrambin + "' " + c.options);
    EXPECT_EQ(outcome.code, 2) << c.options;
    EXPECT_TRUE(contains(outcome.err, c.said)) << c.options << "\n" << outcome.err;
  }
}

}  // namespace
}  // namespace alphascope::testing
