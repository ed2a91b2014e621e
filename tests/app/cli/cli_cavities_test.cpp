// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli cavities from files to numbers, and that the output names the choices. The
// numbers of each cavity are compared with tables in tests/core/cavity.
#include <algorithm>
#include <cmath>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/grid_of_balls.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope::testing {
namespace {

const char* const kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";

class CliCavities : public Cli {
 protected:
  json cavities(const std::string& arguments) {
    const Outcome found = run("cavities -q --json - " + arguments);
    EXPECT_EQ(found.code, 0) << found.err;
    return json::parse(found.out);
  }
};

// Counts and sums by an independent program with the same radii.
TEST_F(CliCavities, OfAPdbFileAreThoseOfTheReference) {
  const json found = cavities(std::string(kHaemoglobin) + " --radii bondi");
  EXPECT_EQ(found["counts"]["voids"], 63);
  EXPECT_EQ(found["counts"]["pockets"], 42);
  EXPECT_EQ(found["counts"]["mouths"], 51);
  EXPECT_EQ(found["cavities"].size(), 105u);
  double voids = 0, all = 0;
  for (const json& cavity : found["cavities"]) {
    const double volume = cavity["volume_sa_angstrom3"];
    all += volume;
    if (cavity["kind"] == "void") voids += volume;
    EXPECT_EQ(cavity["kind"] == "void", cavity["mouths"] == 0);
    EXPECT_EQ(cavity["mouths"], cavity["mouth_list"].size());
    EXPECT_FALSE(cavity["residues"].empty());
  }
  EXPECT_NEAR(voids, 45.28306451, 1e-8);
  EXPECT_NEAR(all, 5600.897645, 1e-6);
  EXPECT_EQ(found["comparable_with_castp"], false);
  EXPECT_EQ(found["differences_from_castp"], json::array({"radii Bondi"}));
}

// A haem pocket is named by the atoms around its deepest point, and a haem in it fills it.
TEST_F(CliCavities, ThePresetLeavesLigandsOutOfTheBody) {
  const json empty = cavities(kHaemoglobin);
  EXPECT_EQ(empty["comparable_with_castp"], true);
  EXPECT_EQ(empty["request"]["solvent_radius_angstrom"], 1.4);
  const auto at_proximal_histidine = [](const json& found) {
    double volume = 0;
    for (const json& cavity : found["cavities"]) {
      for (const json& residue : cavity["residues"]) {
        if (residue["residue"] == "A:HIS 87") volume += cavity["volume_sa_angstrom3"].get<double>();
      }
    }
    return volume;
  };
  EXPECT_GT(at_proximal_histidine(empty), 150);
  const json filled = cavities(std::string(kHaemoglobin) + " --ligands");
  EXPECT_EQ(filled["comparable_with_castp"], false);
  EXPECT_LT(at_proximal_histidine(filled), 20);
  const Outcome text = run("cavities --ligands " + std::string(kHaemoglobin));
  EXPECT_TRUE(contains(text.out, "not comparable with CASTp: ligands are in the body")) << text.out;
}

TEST_F(CliCavities, ARowOfTheCsvIsACavity) {
  const Outcome found = run("cavities -q --csv - " + std::string(kHaemoglobin));
  const auto rows = csv_rows(found.out);
  const json same = cavities(kHaemoglobin);
  ASSERT_EQ(rows.size(), same["cavities"].size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(rows[row].at("id"), std::to_string(row + 1));
    EXPECT_EQ(rows[row].at("name"), same["cavities"][row]["name"]);
    EXPECT_EQ(std::stod(rows[row].at("volume_sa_angstrom3")),
              same["cavities"][row]["volume_sa_angstrom3"]);
    EXPECT_EQ(rows[row].at("choices"), "comparable with CASTp");
  }
}

TEST_F(CliCavities, OfFewBallsThereAreNone) {
  const std::string flat = write("flat.xyzr", "0 0 0 1\n3 0 0 1\n0 3 0 1\n").string();
  const Outcome found = run("cavities '" + flat + "'");
  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(contains(found.out, "lie in one plane")) << found.out;
  EXPECT_TRUE(contains(found.out, "radii from the file")) << found.out;
  const Outcome wrong = run("cavities --rule nonsense '" + flat + "'");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "castp")) << wrong.err;
}

// One of the 11 tetrahedra of this pocket flows both outside and deeper into it.
TEST_F(CliCavities, TheRuleSaysWhatIsOutside) {
  const std::string file = write("rule.xyzr",
                                 "-2 -3 0 1\n"
                                 "-3 3 3 1\n"
                                 "3 2 -1 1\n"
                                 "-3 3 -4 1\n"
                                 "2 2 -4 1\n"
                                 "3 0 -1 1\n"
                                 "-3 1 -4 1\n"
                                 "-4 -4 4 1\n"
                                 "-4 2 -1 1\n"
                                 "2 -4 4 1\n"
                                 "-1 3 3 1\n"
                                 "4 -1 1 1\n")
                               .string();
  const json castp = cavities("'" + file + "' --solvent 0"),
             pocket = cavities("'" + file + "' --solvent 0 --rule pocket");
  ASSERT_EQ(castp["cavities"].size(), 1u);
  ASSERT_EQ(pocket["cavities"].size(), 1u);
  EXPECT_EQ(castp["cavities"][0]["tetrahedra"], 11);
  EXPECT_EQ(pocket["cavities"][0]["tetrahedra"], 10);
}

// The balls of a grid cover all edges of its cubes, but no square. So each square of the boundary
// is a mouth. A grid of 2 x 2 x 2 cubes has 6 · 4 of them, and one of 1 x 2 x 2 cubes has 2 · 4 + 4
// · 2.
TEST_F(CliCavities, APocketOfManyMouthsIsCalledANetwork) {
  const auto grid = [&](int layers) {
    return "'" + write("grid.xyzr", grid_of_balls(layers)).string() + "' --solvent 1";
  };
  const json few = cavities(grid(2));
  ASSERT_EQ(few["cavities"].size(), 1u);
  EXPECT_EQ(few["cavities"][0]["mouths"], 16);
  EXPECT_EQ(few["cavities"][0]["network"], false);
  EXPECT_FALSE(contains(few["notes"].dump(), "network"));
  const json many = cavities(grid(3));
  ASSERT_EQ(many["cavities"].size(), 1u);
  EXPECT_EQ(many["cavities"][0]["mouths"], 24);
  EXPECT_EQ(many["cavities"][0]["network"], true);
  EXPECT_TRUE(contains(many["notes"].dump(), "cavity 1 has 24 mouths: it is a network"));
  const auto rows = csv_rows(run("cavities -q --csv - " + grid(3)).out);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("network"), "1");
  EXPECT_EQ(rows[0].at("kind"), "pocket");
  // The squares close at alpha 3.125 - 1.69, or with a solvent radius of 1.4678. Eight cubes are
  // left.
  const json& apart = many["cavities"][0]["falls_apart"];
  EXPECT_EQ(apart["alpha_angstrom2"], 1.44);
  EXPECT_EQ(apart["cavities_at_alpha"], 8);
  EXPECT_EQ(apart["solvent_radius_angstrom"], 1.5);
  EXPECT_EQ(apart["solvent_radius_step_angstrom"], 0.1);
  EXPECT_EQ(apart["cavities"], 8);
  EXPECT_TRUE(contains(many["notes"].dump(), "at --solvent 1.5, to 0.1 Å, no network is left"));
  EXPECT_EQ(rows[0].at("falls_apart_alpha_angstrom2"), "1.44");
  EXPECT_EQ(rows[0].at("falls_apart_solvent_radius_angstrom"), "1.5");
  EXPECT_TRUE(few["cavities"][0]["falls_apart"].is_null());
  const json asked_less = cavities(grid(3) + " --no-network-radius");
  EXPECT_TRUE(asked_less["cavities"][0]["falls_apart"].is_null());
  EXPECT_TRUE(contains(asked_less["notes"].dump(), "a larger --solvent divides it"));
}

TEST_F(CliCavities, ANetworkIsListedAsItsParts) {
  const std::string file = "'" + write("grid.xyzr", grid_of_balls()).string() + "' --solvent 1";
  const json whole = cavities(file), split = cavities(file + " --split-networks");
  EXPECT_EQ(whole["split_networks"], json::array());
  EXPECT_EQ(whole["request"]["split_networks"], false);
  EXPECT_EQ(split["request"]["split_networks"], true);
  ASSERT_EQ(split["split_networks"].size(), 1u);
  const json& network = split["split_networks"][0];
  EXPECT_EQ(network["mouths"], 24);
  EXPECT_EQ(network["parts"], 8);
  EXPECT_EQ(network["falls_apart_alpha_angstrom2"], 1.44);
  ASSERT_EQ(split["cavities"].size(), 8u);
  double volume = 0;
  for (const json& part : split["cavities"]) {
    EXPECT_EQ(part["kind"], "part");
    EXPECT_EQ(part["part_of"], 1);
    EXPECT_EQ(part["mouths"], 3);
    EXPECT_EQ(part["passages"], 3);
    EXPECT_EQ(part["network"], false);
    EXPECT_NEAR(part["volume_of_tetrahedra_angstrom3"], 15.625, 1e-9);
    volume += part["volume_sa_angstrom3"].get<double>();
  }
  EXPECT_NEAR(volume, whole["cavities"][0]["volume_sa_angstrom3"], 1e-9);
  EXPECT_EQ(split["comparable_with_castp"], false);
  EXPECT_EQ(split["counts"]["pockets"], 8);
  EXPECT_EQ(split["counts"]["voids"], 0);
  EXPECT_TRUE(contains(split["notes"].dump(), "a network of 24 mouths is listed as 8 parts"));
  const auto rows = csv_rows(run("cavities -q --csv - --split-networks " + file).out);
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[7].at("kind"), "part");
  EXPECT_EQ(rows[7].at("part_of"), "1");
  EXPECT_EQ(rows[7].at("passages"), "3");
  const Outcome text = run("cavities --split-networks " + file);
  EXPECT_TRUE(contains(text.out, "part")) << text.out;
}

// Balls of radius 2 in rings of radius 5 around the z axis. The middle ring has radius 4, so a ball
// of radius 2 can pass.
TEST_F(CliCavities, AChannelIsAsWideAsItsNarrowestRing) {
  std::string tube;
  for (int ring = -8; ring <= 8; ++ring) {
    const double radius = ring == 0 ? 4 : 5;
    for (int k = 0; k < 24; ++k) {
      const double angle = (k + 0.5 * (ring & 1)) * 2 * 3.14159265358979 / 24;
      char line[100];
      std::snprintf(line, sizeof line, "%.3f %.3f %.3f 2\n", radius * std::cos(angle),
                    radius * std::sin(angle), 1.0 * ring);
      tube += line;
    }
  }
  const std::string file = write("tube.xyzr", tube).string();
  const Outcome found = run("channel '" + file + "' --point 0,0,1.5 --along 0,0,1 -q --json -");
  ASSERT_EQ(found.code, 0) << found.err;
  const json channel = json::parse(found.out);
  EXPECT_NEAR(channel["widest_angstrom"], 2, 0.01);
  EXPECT_NEAR(channel["bottleneck"]["position_angstrom"][2], 0, 0.05);
  EXPECT_GE(channel["bottleneck"]["touching"].size(), 3u);
  EXPECT_EQ(channel["way"], nullptr);
  EXPECT_EQ(channel["is_whole"], true);
  EXPECT_FALSE(channel.contains("ways"));
  EXPECT_EQ(found.err, "") << "it is to be quiet";
  const Outcome loud = run("channel '" + file + "' --point 0,0,1.5 --along 0,0,1 --json -");
  EXPECT_EQ(json::parse(loud.out)["widest_angstrom"], channel["widest_angstrom"]);
  EXPECT_TRUE(contains(loud.err, "bottleneck")) << loud.err;
  const Outcome rows = run("channel '" + file + "' --point 0,0,1.5 --along 0,0,1 -q --csv -");
  EXPECT_EQ(csv_rows(rows.out).size(), channel["samples"].size());

  // The same without a start point.
  const Outcome through = run("channel '" + file + "' -q --json -");
  ASSERT_EQ(through.code, 0) << through.err;
  const json way = json::parse(through.out);
  EXPECT_NEAR(way["widest_angstrom"], channel["widest_angstrom"], 0.0011);
  EXPECT_EQ(way["way"]["number"], 1);
  EXPECT_EQ(way["way"]["through"], "the whole molecule");
  EXPECT_EQ(way["request"], (json{{"kind", "way"}, {"way", 1}}));
  ASSERT_EQ(way["ways"].size(), 1u);
  EXPECT_EQ(way["ways"][0]["widest_angstrom"], way["widest_angstrom"]);
  const Outcome text = run("channel '" + file + "'");
  for (const char* part : {"ways        1 * the whole molecule: radius ",
                           "covers      16.0 of 16.0", "passes      one water passes at a time"}) {
    EXPECT_TRUE(contains(text.out, part)) << text.out;
  }
  const Outcome second = run("channel '" + file + "' --way 2");
  EXPECT_EQ(second.code, 2);
  EXPECT_TRUE(contains(second.err, "There is no way 2")) << second.err;
}

// A channel that ends inside is only a part of a way, so there is no verdict on the whole way.
TEST_F(CliCavities, OfAPartThereIsNoVerdict) {
  std::string cup;
  for (int ring = -8; ring <= 8; ++ring) {
    for (int k = 0; k < 24; ++k) {
      const double angle = (k + 0.5 * (ring & 1)) * 2 * 3.14159265358979 / 24;
      char line[100];
      std::snprintf(line, sizeof line, "%.3f %.3f %.3f 2\n", 5 * std::cos(angle),
                    5 * std::sin(angle), 1.0 * ring);
      cup += line;
    }
  }
  for (int k = 0; k < 8; ++k) {
    const double angle = k * 2 * 3.14159265358979 / 8;
    char line[100];
    std::snprintf(line, sizeof line, "%.3f %.3f -8 2\n", 2.5 * std::cos(angle),
                  2.5 * std::sin(angle));
    cup += line;
  }
  const std::string file = write("cup.xyzr", cup + "0 0 -8 2\n").string();
  const Outcome none = run("channel '" + file + "'");
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "No way leads through the molecule")) << none.err;
  const Outcome part = run("channel '" + file + "' --point 0,0,0");
  ASSERT_EQ(part.code, 0) << part.err;
  EXPECT_TRUE(contains(part.out, "nothing is said about what passes the molecule")) << part.out;
  EXPECT_FALSE(contains(part.out, "waters pass")) << part.out;
}

// Files are opened without options. References are HOLE's radius of gramicidin with its radii,
// CHAP's radius of TRPV3, and KcsA's filter from a point inside it.
TEST_F(CliCavities, TheWaysThroughKnownPoresAreFound) {
  ALPHASCOPE_NEED_TEST_DATA();
  const std::string data = test_data_folder().string() + "/";
  const auto ways = [&](const std::string& arguments) {
    const Outcome found = run("channel -q --json - " + data + arguments);
    EXPECT_EQ(found.code, 0) << found.err;
    return json::parse(found.out);
  };
  const auto expect_place = [](const json& way, double x, double y, double z) {
    const json& p = way["bottleneck"]["position_angstrom"];
    EXPECT_NEAR(p[0], x, 1);
    EXPECT_NEAR(p[1], y, 1);
    EXPECT_NEAR(p[2], z, 1);
  };
  const json trpv3 = ways("ladder/6mhs.pdb.gz --radii bondi --hydrogens keep");
  EXPECT_NEAR(trpv3["widest_angstrom"], 1.03, 0.05);
  expect_place(trpv3, 0, 0, 20.7);
  EXPECT_EQ(trpv3["way"]["lining_chains"].size(), 4u);
  const json without_hydrogens = ways("ladder/6mhs.pdb.gz");
  EXPECT_NEAR(without_hydrogens["widest_angstrom"], 1.16, 0.05);
  expect_place(without_hydrogens, 0, 0, 20.7);

  const json kcsa = ways("thesis/1k4c.pdb.gz --assembly 1");
  EXPECT_NEAR(kcsa["widest_angstrom"], 0.847, 0.05);
  expect_place(kcsa, 155.33, 155.33, -38.6);
  EXPECT_EQ(kcsa["way"]["lining_chains"].size(), 4u);
  // Each way is on the axis, and so in all four copies.
  const json with_ions = ways("thesis/1k4c.pdb.gz --assembly 1 --ions");
  EXPECT_EQ(with_ions["way"]["not_counted"]["ions"], 7);

  const json gramicidin = ways("cavities/hole/1grm_single.pdb --radii bondi");
  EXPECT_NEAR(gramicidin["widest_angstrom"], gramicidin["ways"][0]["widest_angstrom"].get<double>(),
              1e-12);
  EXPECT_EQ(gramicidin["way"]["lining_chains"], json::array({"A", "B"}));
  EXPECT_EQ(gramicidin["way"]["through"], "the whole molecule");

  const json toxin = ways("cavities/hole/1chb.pdb.gz");
  EXPECT_NEAR(toxin["widest_angstrom"], 3.006, 0.05);
  EXPECT_EQ(toxin["way"]["lining_chains"].size(), 5u);

  // A pore in each chain and none on the axis.
  const json porin = ways("cavities/hole/1af6.pdb.gz");
  ASSERT_GE(porin["ways"].size(), 3u);
  std::vector<std::string> through;
  for (int n = 0; n < 3; ++n) {
    through.push_back(porin["ways"][n]["way"]["through"]);
    EXPECT_NEAR(porin["ways"][n]["widest_angstrom"], 2.215, 0.03);
  }
  std::sort(through.begin(), through.end());
  EXPECT_EQ(through, (std::vector<std::string>{"chain A", "chain B", "chain C"}));
}

// The way leads out of the cube through a gap and back through the same gap. The whole way is known
// all the same.
TEST_F(CliCavities, OfAChannelThatComesBackTheWholeIsKnown) {
  const Outcome found =
      run("channel '" + cube_.string() + "' --point 1,1,1 --along 0,0,1 -q --json -");
  ASSERT_EQ(found.code, 0) << found.err;
  const json channel = json::parse(found.out);
  EXPECT_GT(channel["whole_angstrom"], 1.9);
  EXPECT_LE(channel["covered_angstrom"], channel["whole_angstrom"]);
}

// Other programs do not open lists of balls. So a script for them is refused before anything is
// computed.
TEST_F(CliCavities, AScriptOfWhatOthersDoNotOpenIsRefusedAtOnce) {
  for (const char* command : {"channel --point 1,1,1", "cavities"}) {
    const Outcome refused = run(std::string(command) + " '" + cube_.string() + "' --script '" +
                                (folder_ / "o.cxc").string() + "'");
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_EQ(refused.out, "") << command;
    EXPECT_TRUE(contains(refused.err, "do not open XYZR files")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_ / "o.cxc"));
  }
}

TEST_F(CliCavities, APointWithinAnAtomIsNamed) {
  const std::string file = write("one.xyzr", "0 0 0 2\n3 0 0 2\n0 3 0 2\n0 0 3 2\n").string();
  const Outcome covered = run("channel '" + file + "' --point 0.5,0,0");
  EXPECT_EQ(covered.code, 2);
  EXPECT_TRUE(contains(covered.err, "#1")) << covered.err;
  const Outcome two = run("channel '" + file + "' --point 0.5,0");
  EXPECT_EQ(two.code, 2);
  EXPECT_TRUE(contains(two.err, "three numbers")) << two.err;
}

// Ways from a cavity's widest place to the outside and to a mouth, and impossible requests.
TEST_F(CliCavities, AChannelBeginsInACavity) {
  const std::string file = std::string(kHaemoglobin);
  const auto channel = [&](const std::string& more) {
    const Outcome found = run("channel " + file + " -q --json - " + more);
    EXPECT_EQ(found.code, 0) << found.err;
    return json::parse(found.out);
  };
  const json out = channel("--cavity 4");
  EXPECT_EQ(out["request"]["cavity"], 4);
  EXPECT_GE(out["widest_angstrom"].get<double>(), 1.4) << "a pocket opens for a solvent of 1.4 Å";
  // The same way from the point itself.
  const json& at = out["request"]["point_angstrom"];
  const json same = channel("--point=" + at[0].dump() + "," + at[1].dump() + "," + at[2].dump());
  EXPECT_EQ(same["widest_angstrom"], out["widest_angstrom"]);
  EXPECT_FALSE(same["request"].contains("cavity"));
  const json mouth = channel("--cavity 4 --mouth 1");
  EXPECT_TRUE(mouth["request"].contains("to_angstrom"));
  EXPECT_EQ(mouth["request"]["mouths"], json::array({1.0}));
  // The opening of the mouth has no single middle. The line must not run to and fro in it.
  EXPECT_LT(mouth["length_angstrom"].get<double>(), 18);

  std::size_t a_void = 0;
  const json listed = cavities(kHaemoglobin)["cavities"];
  while (listed[a_void]["kind"] != "void") ++a_void;
  const auto refused = [&](const std::string& more, const std::string& why) {
    const Outcome outcome = run("channel " + file + " " + more);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome.err, why)) << outcome.err;
  };
  refused("--cavity 999", "There is no cavity 999");
  refused("--cavity " + std::to_string(a_void + 1) + " --mouth 1", "it is a void");
  refused("--cavity 4 --mouth 99", "no mouth 99");
  refused("--point 1,2,3 --cavity 4", "exclude each other");
  refused("--along 0,0,1", "need --point X,Y,Z or --cavity N");
  refused("--cavity 4 --way 1", "--way cannot be used with --point or --cavity");
  refused("--point 1,2,3 --mouth 1", "--mouth needs --cavity");
  refused("--cavity 4 --mouth 1 --along 0,0,1", "exclude each other");
}

// Left-out values are null or empty, and a note says so. All other values stay.
TEST_F(CliCavities, WithoutClippedVolumesNothingElseChanges) {
  const std::string file = kHaemoglobin;
  const auto found = [&](const std::string& more) {
    return json::parse(run("cavities -q --json - " + file + more).out);
  };
  json all = found(""), without = found(" --no-clipped");
  ASSERT_EQ(all["cavities"].size(), without["cavities"].size());
  ASSERT_GT(all["cavities"].size(), 50u);
  for (const char* key : {"volume_sa_clipped_angstrom3", "area_sa_clipped_angstrom2",
                          "rank_by_clipped_volume", "doubtful"}) {
    for (json& cavity : all["cavities"]) EXPECT_FALSE(cavity[key].is_null()) << key;
    for (json& cavity : without["cavities"]) {
      EXPECT_TRUE(cavity.contains(key) && cavity[key].is_null()) << key;
    }
    for (json& cavity : all["cavities"]) cavity[key] = nullptr;
  }
  EXPECT_EQ(all["cavities"], without["cavities"]);
  EXPECT_TRUE(contains(without["notes"].dump(), "--no-clipped"));
  EXPECT_FALSE(contains(all["notes"].dump(), "--no-clipped"));
  for (const auto& row : csv_rows(run("cavities -q --csv - " + file + " --no-clipped").out)) {
    EXPECT_EQ(row.at("volume_sa_clipped_angstrom3"), "");
    EXPECT_EQ(row.at("rank_by_clipped_volume"), "");
    EXPECT_EQ(row.at("doubtful"), "");
    EXPECT_NE(row.at("volume_sa_angstrom3"), "");
  }
  const Outcome text = run("cavities " + file + " --no-clipped --show 2");
  EXPECT_TRUE(contains(text.out, "left out because of --no-clipped")) << text.out;
}

// Two balls have closed forms, for the total and for each atom.
TEST_F(CliCavities, MeasuresAreExactAndAddUp) {
  const std::string file = write("two.xyzr", "0 0 0 1\n1 0 0 1\n").string();
  const Outcome found = run("measure '" + file + "' --per atom -q --json -");
  ASSERT_EQ(found.code, 0) << found.err;
  const json measures = json::parse(found.out);
  const double pi = 3.14159265358979323846;
  EXPECT_EQ(measures["surface"], "van der Waals surface");
  EXPECT_NEAR(measures["area_angstrom2"], 6 * pi, 1e-12);
  EXPECT_NEAR(measures["volume_angstrom3"], 9 * pi / 4, 1e-12);
  EXPECT_NEAR(measures["arc_length_angstrom"], std::sqrt(3.0) * pi, 1e-12);
  ASSERT_EQ(measures["atoms"].size(), 2u);
  EXPECT_EQ(measures["atoms"][0]["name"], "#1");
  EXPECT_NEAR(measures["atoms"][0]["area_angstrom2"], 3 * pi, 1e-12);
  EXPECT_NEAR(measures["atoms"][0]["arc_length_angstrom"], std::sqrt(0.75) * pi, 1e-12);
  EXPECT_NEAR(measures["atoms"][0]["exposed_share"], 0.75, 1e-12);
  EXPECT_FALSE(measures["atoms"][0].contains("area_by_x_angstrom"));
  // With alpha 1 both radii are the square root of 2. Half a diameter and 1/2 Å are free.
  const Outcome grown = run("measure '" + file + "' --per atom --alpha 1 -q --json -");
  const json larger = json::parse(grown.out);
  for (const json& atom : larger["atoms"]) {
    EXPECT_NEAR(atom["exposed_share"], 0.676776695296637, 1e-12);
    EXPECT_NEAR(atom["area_angstrom2"], 8 * pi * 0.676776695296637, 1e-12);
  }
  const Outcome chains =
      run("measure " + std::string(kHaemoglobin) + " --solvent 1.4 --per chain -q --csv -");
  const auto rows = csv_rows(chains.out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].at("group"), "A");
  EXPECT_EQ(rows[0].at("surface"), "solvent-accessible surface, probe of 1.4 Å");
}

TEST_F(CliCavities, ComponentsShareAreaAndVolume) {
  const std::string file = write("three.xyzr", "9 0 0 2\n0 0 0 1\n1 0 0 1\n").string();
  const Outcome found = run("measure '" + file + "' -q --json -");
  ASSERT_EQ(found.code, 0) << found.err;
  const json components = json::parse(found.out)["components"];
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0]["name"], "#1");
  EXPECT_EQ(components[1]["atoms"], 2);
  EXPECT_NEAR(components[0]["share_of_area"], 16.0 / 22, 1e-12);
  EXPECT_NEAR(components[1]["share_of_area"], 6.0 / 22, 1e-12);
  const auto rows = csv_rows(run("measure '" + file + "' --per component -q --csv -").out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].at("atoms"), "2");
  EXPECT_TRUE(contains(run("measure '" + file + "'").out, "the largest has 82.58 %"));
}

// If one of two balls moves away, their overlap shrinks. The derivative of the volume is the area
// of the disc between them, for each ball.
TEST_F(CliCavities, DerivativesAreOfEachAtom) {
  const std::string file = write("two.xyzr", "0 0 0 1\n1 0 0 1\n").string();
  const auto rows = csv_rows(run("measure '" + file + "' --per atom --derivatives -q --csv -").out);
  ASSERT_EQ(rows.size(), 2u);
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(std::stod(rows[0].at("volume_by_x_angstrom2")), -0.75 * pi, 1e-12);
  EXPECT_NEAR(std::stod(rows[1].at("volume_by_x_angstrom2")), 0.75 * pi, 1e-12);
  EXPECT_NEAR(std::stod(rows[0].at("volume_by_radius_angstrom2")), 3 * pi, 1e-12);
  EXPECT_NEAR(std::stod(rows[0].at("area_by_x_angstrom")), -2 * pi, 1e-12);
  EXPECT_NEAR(std::stod(rows[0].at("area_by_radius_angstrom")), 5 * pi, 1e-12);
  const Outcome without = run("measure '" + file + "' --derivatives");
  EXPECT_EQ(without.code, 2);
  EXPECT_TRUE(contains(without.err, "add --per atom")) << without.err;
}

// The space between two distant bodies is a pocket by definition, and a note must say so.
TEST_F(CliCavities, SeparateBodiesAreNamed) {
  const std::string apart = write("apart.xyzr",
                                  "0 0 0 2\n2 0 0 2\n0 2 0 2\n0 0 2 2\n"
                                  "40 0 0 2\n42 0 0 2\n40 2 0 2\n40 0 2 2\n")
                                .string();
  const Outcome found = run("cavities '" + apart + "'");
  EXPECT_TRUE(contains(found.out, "2 separate parts")) << found.out;
}

}  // namespace
}  // namespace alphascope::testing
