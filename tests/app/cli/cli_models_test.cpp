// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli on files of several models, and the provenance in every kind of output.
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

constexpr const char* kProvenance[] = {"file",
                                       "fetched",
                                       "sha256",
                                       "format",
                                       "model",
                                       "assembly",
                                       "options",
                                       "selection_expression",
                                       "selection",
                                       "radii",
                                       "lattice_unit_angstrom",
                                       "rounding_angstrom",
                                       "radius_rounding_angstrom",
                                       "program"};

// Two models: an edge, and three balls, the third of a water.
constexpr const char* kTwoModels =
    "MODEL        4\n"
    "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  ALA A   2       3.000   0.000   0.000  1.00  9.67           C  \n"
    "ENDMDL\nMODEL        9\n"
    "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  ALA A   2       9.000   0.000   0.000  1.00  9.67           C  \n"
    "HETATM    3  O   HOH A   3       1.500   1.500   0.000  1.00  9.67           O  \n"
    "ENDMDL\n";

TEST_F(Cli, ASolventRadiusIsExactOrSaidToBeRounded) {
  const std::string small = "0 0 0 1.5\n3 0 0 1.5\n";
  const std::string near = write("near.xyzr", small).string();
  const std::string far = write("far.xyzr", small + "500000000 0 0 2\n").string();
  // The balls touch at a solvent radius of 0. A radius of 0.0004 is different.
  const json fine = compute_json("'" + near + "' --alpha 0 --solvent 0.0004");
  EXPECT_EQ(fine["request"]["solvent_radius_used_angstrom"], 0.0004);
  EXPECT_EQ(fine["request"]["lattice_unit_angstrom"], 0.0001);
  const Outcome coarse = run("compute '" + far + "' --alpha 0 --solvent 1.4");
  EXPECT_TRUE(contains(coarse.out, "solvent radius of 1.4 Å is rounded to 1 Å")) << coarse.out;
  const Outcome verified = run("verify '" + far + "' --alpha 0 --solvent 1.4");
  EXPECT_TRUE(contains(verified.out, "rounded to 1 Å")) << verified.out;
  const fs::path out = folder_ / "far.alpha";
  run("compute '" + far + "' --alpha 0 --solvent 1.4 --out '" + out.string() + "'");
  EXPECT_TRUE(contains(contents(out), "solvent_rounding_angstrom 0.4\n")) << contents(out);
}

TEST_F(Cli, EachModelGivesAResultOfItsOwn) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' --alpha 0 ";
  const fs::path csv = folder_ / "m.csv", out = folder_ / "m.alpha", js = folder_ / "m.json";
  const Outcome outcome = run("compute " + file + "--model all --csv '" + csv.string() +
                              "' --out '" + out.string() + "' --json '" + js.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json models = json::parse(contents(js))["models"];
  ASSERT_EQ(models.size(), 2u);
  const auto rows = csv_rows(contents(csv));
  ASSERT_EQ(rows.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    // Exactly the result of the model alone.
    const json alone = compute_json(file + "--model " + std::to_string(k + 1));
    EXPECT_EQ(models[k]["hash"], alone["hash"]);
    EXPECT_EQ(models[k]["counts"], alone["counts"]);
    EXPECT_EQ(models[k]["input"]["selection"], alone["input"]["selection"]);
    EXPECT_EQ(models[k]["input"]["model"], k + 1);
    EXPECT_EQ(rows[k].at("model"), std::to_string(k + 1));
    EXPECT_EQ(rows[k].at("hash"), alone["hash"]);
    EXPECT_EQ(rows[k].at("edges"), alone["counts"]["edges"].dump());
    EXPECT_TRUE(contains(outcome.out, alone["hash"])) << outcome.out;
  }
  EXPECT_EQ(models[0]["counts"]["edges"], 1);
  EXPECT_EQ(models[1]["counts"]["edges"], 0);
  EXPECT_EQ(models[0]["input"]["model_number_in_file"], 4);
  // The documents follow one another.
  const std::string text = contents(out);
  std::size_t documents = 0;
  for (std::size_t at = text.find("alphascope-complex 1\n"); at != text.npos;
       at = text.find("alphascope-complex 1\n", at + 1)) {
    ++documents;
  }
  EXPECT_EQ(documents, 2u);
  EXPECT_TRUE(contains(text, "\nmodel 2\n"));
  EXPECT_TRUE(text.ends_with("\nend\n"));
}

TEST_F(Cli, CsvOnStandardOutputIsAlone) {
  const Outcome outcome =
      run("compute '" + write("two.pdb", kTwoModels).string() + "' --alpha 0 --model all --csv -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = csv_rows(outcome.out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].at("balls"), "2");
  const Outcome times = run("bench '" + cube_.string() + "' --alpha 0 --runs 1 --csv -");
  EXPECT_EQ(csv_rows(times.out).at(0).at("identical"), "1");
}

TEST_F(Cli, AModelWithoutBallsIsAnEmptyResult) {
  const json models = compute_json("'" + write("two.pdb", kTwoModels).string() +
                                   "' --alpha 0 --model all --waters --select water")["models"];
  ASSERT_EQ(models.size(), 2u);
  EXPECT_EQ(models[0]["input"]["balls"], 0);
  EXPECT_EQ(models[0]["counts"]["vertices"], 0);
  EXPECT_EQ(models[1]["counts"]["vertices"], 1);
}

TEST_F(Cli, JoinedModelsAreOneSet) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' ";
  const json joined = compute_json(file + "--alpha 0 --model joined --waters");
  EXPECT_EQ(joined["input"]["balls"], 5);
  EXPECT_EQ(joined["input"]["model"], "joined");
  EXPECT_EQ(joined["input"]["options"], "--waters");
  EXPECT_EQ(compute_json(file + "--alpha 0 --model 2 --no-polymers --waters")["input"]["balls"], 1);
  EXPECT_EQ(run("compute " + file + "--alpha 0 --model 3").code, 2);
  EXPECT_EQ(
      run("screenshot " + file + "--alpha 0 --model all -o '" + (folder_ / "x.png").string() + "'")
          .code,
      2)
      << "one picture, one model";
}

TEST_F(Cli, VerifyAndInfoTakeEachModelToo) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' --model all ";
  const Outcome verified = run("verify " + file + "--alpha 0,9 --json -");
  ASSERT_EQ(verified.code, 0) << verified.err;
  const json results = json::parse(verified.out)["results"];
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[3]["input"]["model"], 2);
  const json info = json::parse(run("info " + file + "--json -").out);
  ASSERT_EQ(info["models"].size(), 2u);
  EXPECT_EQ(info["models"][1]["input"]["atoms_used"], 2);
  EXPECT_TRUE(contains(run("info " + file).out, "model 2: used 2 of 3 atoms; dropped 1 water"));
}

TEST_F(Cli, EveryOutputSaysWhereItComesFrom) {
  const fs::path csv = folder_ / "c.csv", times = folder_ / "t.csv", out = folder_ / "c.alpha";
  const fs::path table = write("mine.txt", "C 1.5\nX 1.25\n");
  const std::string file = "'" + cube_.string() + "' --alpha 1 --radii '" + table.string() + "' ";
  ASSERT_EQ(
      run("compute " + file + "--csv '" + csv.string() + "' --out '" + out.string() + "'").code, 0);
  ASSERT_EQ(run("bench " + file + "--runs 1 --csv '" + times.string() + "'").code, 0);
  const json result = compute_json(file);
  const std::string text = contents(out);
  for (const fs::path& path : {csv, times}) {
    const auto rows = csv_rows(contents(path));
    ASSERT_EQ(rows.size(), 1u);
    for (const char* key : kProvenance) EXPECT_TRUE(rows[0].contains(key)) << path << ' ' << key;
    EXPECT_EQ(rows[0].at("sha256"), result["input"]["sha256"]);
    EXPECT_EQ(rows[0].at("lattice_unit_angstrom"), "0.001");
    EXPECT_TRUE(contains(rows[0].at("radii"), result["input"]["radii"]["table_sha256"]));
    EXPECT_EQ(rows[0].at("selection"), result["input"]["selection"]);
  }
  for (const char* key : kProvenance) {
    EXPECT_TRUE(contains(text, std::string("\n") + key + " ")) << key;
  }
  EXPECT_TRUE(contains(run("compute " + file).out, result["input"]["sha256"]));
}

TEST_F(Cli, PicturesSayWhereTheyComeFrom) {
  const fs::path picture = folder_ / "cube.png";
  const Outcome outcome = run("screenshot '" + cube_.string() + "' --alpha 1 --size 64x64 -o '" +
                              picture.string() + "'");
  if (!kDrawsPictures) GTEST_SKIP() << "built without the viewer";
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string png = contents(picture);
  const json input = compute_json("'" + cube_.string() + "' --alpha 1")["input"];
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  EXPECT_TRUE(contains(png, "alphascope:sha256"));
  EXPECT_TRUE(contains(png, input["sha256"]));
  EXPECT_TRUE(contains(png, "alphascope:alpha_angstrom2"));
}

}  // namespace
}  // namespace alphascope::testing
