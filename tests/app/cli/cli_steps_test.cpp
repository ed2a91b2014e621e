// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli steps on small files: sentences, JSON, switches, and messages for wrong
// balls.
#include <set>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

class CliSteps : public Cli {
 protected:
  json steps(const std::string& arguments) const {
    const Outcome outcome = run("steps " + arguments + " --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
  static json step(const json& all, const std::string& id) {
    for (const json& one : all["steps"]) {
      if (one["step"] == id) return one;
    }
    ADD_FAILURE() << "no step " << id;
    return {};
  }
};

// Balls of radius 1.5 at the corners of a cube of side 2. A corner meets all others but the
// opposite one, which is 3.46 away.
TEST_F(CliSteps, ShowsOneCornerOfACube) {
  const std::string corner = "'" + cube_.string() + "' --ball 0 --alpha 0";
  const json all = steps(corner);
  EXPECT_EQ(all["engine"], "tuples");
  EXPECT_EQ(all["ball"], 0);
  EXPECT_EQ(all["alpha_angstrom2"], 0);
  EXPECT_EQ(step(all, "grid")["counts"]["balls_in_grid"], 8);
  EXPECT_EQ(step(all, "cube")["counts"]["neighbours"], 7);
  EXPECT_EQ(step(all, "pairs")["counts"], json({{"made", 7}, {"dropped", 1}, {"kept", 6}}));
  // Three edges, and the diagonals of three sides. No orthocentre of four balls is within.
  EXPECT_EQ(all["star"]["vertices"], json({{0}}));
  EXPECT_EQ(all["star"]["tetrahedra"], json::array());
  const auto edges = all["star"]["edges"].get<std::vector<std::vector<int>>>();
  for (const std::vector<int>& edge : {std::vector{0, 1}, {0, 2}, {0, 4}}) {
    EXPECT_EQ(std::count(edges.begin(), edges.end(), edge), 1);
  }
  EXPECT_EQ(step(all, "result")["counts"]["edges"], edges.size());

  EXPECT_EQ(all["saturation"], json({{"state", "on_hull"}, {"tetrahedra", 1}}));

  const std::string text = run("steps " + corner).out;
  for (const char* part :
       {"1. Grid", "Kernel I: neighbours: 7 neighbours", "Prefix sum", "pairs: 6 of 7 left",
        "Kernel III", "3 edges, 3 triangles and 0 tetrahedra",
        "Saturation    On the hull: never saturated"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
}

// The same corner. Among the edges to its six neighbours, those across faces are attached by ties.
TEST_F(CliSteps, ShowsTheDualEdgeEngine) {
  const std::string corner = "'" + cube_.string() + "' --ball 0 --alpha 0";
  const json all = steps(corner + " --engine dual_edges"), tuples = steps(corner);
  EXPECT_EQ(all["engine"], "dual_edges");
  EXPECT_FALSE(all["request"].contains("edge_optimisation"));
  EXPECT_EQ(step(all, "grid")["counts"]["balls_in_grid"], 8);
  EXPECT_EQ(step(all, "neighbours")["counts"]["neighbours"], 6);
  EXPECT_EQ(step(all, "neighbours")["spheres"][0]["radius_angstrom"], 1.5);
  EXPECT_EQ(step(all, "discs")["switched_off"], true);
  EXPECT_EQ(step(all, "edges")["counts"]["tested"], 6);
  EXPECT_EQ(step(all, "result")["counts"], step(tuples, "result")["counts"]);
  EXPECT_EQ(all["star"], tuples["star"]);

  const std::string text = run("steps --engine dual_edges " + corner).out;
  for (const char* part :
       {"1. Grid", "Kernel I: neighbours: 6 neighbours", "6. Kernel II: dual edges", "Kernel III",
        "3 edges, 3 triangles and 0 tetrahedra"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
}

TEST_F(CliSteps, ListsCutsOfDualEdges) {
  const json all = steps("'" + kCrambin + "' --engine dual_edges --ball 'A:CYS 16:SG' --alpha 1.4");
  const json clipping = step(all, "clipping");
  EXPECT_EQ(clipping["segments"].size(), clipping["counts"]["left"]);
  std::set<std::string> fates;
  for (const json& edge : clipping["dual_edges"]) {
    fates.insert(edge["fate"]);
    EXPECT_LE(edge["settled_after"], edge["cuts"].size());
    EXPECT_LT(edge["within_alpha_angstrom"][0], edge["within_alpha_angstrom"][1]);
    if (edge["fate"] == "dropped") {
      EXPECT_EQ(edge["cuts"].back()["does"], "takes_rest");
    }
  }
  EXPECT_EQ(fates.count("kept") + fates.count("dropped"), 2u);
}

TEST_F(CliSteps, SwitchesAddWork) {
  const std::string atom = "'" + kCrambin + "' --ball 'A:CYS 16:SG' --alpha 1.4";
  const json both = steps(atom), no_edges = steps(atom + " --no-edge-optimisation"),
             none = steps(atom + " --no-edge-optimisation --no-alpha-optimisation");
  const auto count = [&](const json& all, const char* id, const char* what) {
    return step(all, id)["counts"][what].get<int>();
  };
  EXPECT_LT(count(both, "tuples", "kept"), count(no_edges, "tuples", "kept"));
  // Four balls with rho <= alpha meet, so the alpha optimisation alone drops equally many.
  EXPECT_EQ(count(both, "filter", "tested"), count(no_edges, "filter", "tested"));
  EXPECT_LT(count(no_edges, "filter", "tested"), count(none, "filter", "tested"));
  EXPECT_EQ(both["star"], none["star"]);
  EXPECT_EQ(step(none, "pairs")["switched_off"], true);
  EXPECT_TRUE(contains(step(none, "pairs")["text"], "The edge optimisation is off"));
  EXPECT_FALSE(step(no_edges, "alpha").contains("switched_off"));
}

TEST_F(CliSteps, TakesNamesAndNumbers) {
  const std::string file = "'" + kCrambin + "' --alpha 0 --solvent 1.4 --ball ";
  const json by_name = steps(file + "'A:THR 1:CA'");
  EXPECT_EQ(by_name["ball"], 1);
  EXPECT_EQ(by_name["atom"], "A:THR 1:CA");
  EXPECT_EQ(by_name["request"]["solvent_radius_angstrom"], 1.4);
  EXPECT_EQ(by_name["star"], steps(file + "1")["star"]);
}

TEST_F(CliSteps, SaysWhatIsLeftOut) {
  write("hidden.xyzr", "0 0 0 1\n0 0 0 2\n5 0 0 1\n");
  const std::string file = "'" + (folder_ / "hidden.xyzr").string() + "'";
  EXPECT_TRUE(contains(run("steps " + file + " --ball 0 --alpha 0").out,
                       "Another ball has the same centre"));
  const json empty = steps(file + " --ball 2 --alpha -2");
  EXPECT_EQ(empty["steps"].size(), 1u);
  EXPECT_TRUE(contains(empty["steps"][0]["text"], "has shrunk to nothing"));
}

TEST_F(CliSteps, RefusesWhatIsNoBall) {
  const struct {
    const char *options, *said;
  } cases[] = {{"--ball 327", "there is no ball 327: 1crn.pdb has 327 balls, 0 to 326."},
               {"--ball A:", "--ball \"A:\" names 327 atoms that are balls: name one"},
               {"--ball 'chain Q'", "names 0 atoms"},
               {"--ball 99999999999", "--ball \"99999999999\""},
               {"", "--ball is required"},
               {"--ball 1 --model all", "steps takes one model."},
               {"--ball 1 --engine dual_edges --no-alpha-optimisation",
                "the options of the tuple engine need --engine tuples"},
               {"--ball 1 --engine gpu", "tuples, dual_edges"}};
  for (const auto& c : cases) {
    const Outcome outcome = run("steps '" + kCrambin + "' --alpha 0 " + c.options);
    EXPECT_EQ(outcome.code, 2) << c.options;
    EXPECT_TRUE(contains(outcome.err, c.said)) << c.options << "\n" << outcome.err;
  }
  EXPECT_TRUE(contains(run("steps '" + kCrambin + "' --ball 1").err, "--alpha is required"));
}

}  // namespace
}  // namespace alphascope::testing
