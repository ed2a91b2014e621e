// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pictures of alphascope-cli: their overlays and their metadata.
#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/png_chunks.hpp"

namespace alphascope::testing {
namespace {

class CliPictures : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!kDrawsPictures) GTEST_SKIP() << "built without the renderer";
  }
  std::string picture(const std::string& options, const std::string& alpha = "1") const {
    const fs::path file = folder_ / "it's one.png";
    const Outcome outcome = run("screenshot '" + cube_.string() + "' --alpha " + alpha +
                                " --size 320x200 " + options + " -o \"" + file.string() + "\"");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return contents(file);
  }
  static std::string pixels(const std::string& png) {
    std::string all;
    for (const auto& [type, data] : chunks_of(png)) {
      if (type == "IDAT") all += data;
    }
    return all;
  }
};

TEST_F(CliPictures, HaveACaptionOnlyWhenItIsAskedFor) {
  const std::string plain = pixels(picture(""));
  EXPECT_EQ(pixels(picture("--caption none")), plain);
  EXPECT_NE(pixels(picture("--caption alpha")), plain);
  EXPECT_NE(pixels(picture("--caption alpha")), pixels(picture("--caption hash")));
  const Outcome wrong =
      run("screenshot '" + cube_.string() + "' --alpha 1 -o x.png --caption blue");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "\"blue\" is not a part of a caption")) << wrong.err;
}

TEST_F(CliPictures, SayHowTheyAreMadeAgain) {
  const std::string first = picture("--light --caption all");
  const std::string command = texts_of(first)["alphascope:command"];
  EXPECT_TRUE(command.starts_with("alphascope-cli screenshot ")) << command;
  const std::string again = "PATH='" + fs::path(ALPHASCOPE_CLI).parent_path().string() + "' ";
  fs::remove(folder_ / "it's one.png");
  EXPECT_FALSE(contains(command, "it's one")) << "where it lies is no part of it";
  const std::string output = " -o \"" + (folder_ / "it's one.png").string() + "\"";
  ASSERT_EQ(std::system(("{ " + again + command + output + "; } >/dev/null 2>&1").c_str()), 0)
      << command;
  EXPECT_EQ(contents(folder_ / "it's one.png"), first);
}

TEST_F(CliPictures, TellTheNewNameOfAScheme) {
  const std::string there = "screenshot '" + cube_.string() + "' --alpha 1 --size 160x100 -o '" +
                            (folder_ / "a.png").string() + "' --colours residue_";
  const std::string told = "\"residue_kind\" is called \"residue_class\" now";
  const Outcome former = run(there + "kind");
  EXPECT_EQ(former.code, 0) << former.err;
  EXPECT_TRUE(contains(former.err, told)) << former.err;
  EXPECT_FALSE(contains(run(there + "class").err, told));
}

// Grown balls are drawn with their whole radius, even at alpha 0. Other balls have the display's
// share of it.
TEST_F(CliPictures, GrownBallsAreWhole) {
  EXPECT_NE(pixels(picture("--no-shadows --grown", "0")), pixels(picture("--no-shadows", "0")));
  EXPECT_NE(pixels(picture("--no-shadows --grown", "0.5")),
            pixels(picture("--no-shadows --grown", "0")));
}

// With the boundary, tetrahedra are left out, since gaps between them would show.
TEST_F(CliPictures, OfTheBoundaryHaveNoTetrahedra) {
  EXPECT_NE(pixels(picture("--no-balls --shrink 0.5")), pixels(picture("--no-balls")));
  EXPECT_EQ(pixels(picture("--no-balls --clip z --boundary --shrink 0.5")),
            pixels(picture("--no-balls --clip z --boundary")));
}

// A picture of a session says which atoms the session has chosen.
TEST_F(CliPictures, OfASessionSayWhatItsBallsAre) {
  const fs::path molecule = folder_ / "1crn.pdb";
  fs::copy_file(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb", molecule);
  const json info = json::parse(run("info '" + molecule.string() + "' --json -").out);
  const fs::path session = write(
      "s.json", json{{"alphascope_session", 1},
                     {"molecule", {{"path", "1crn.pdb"}, {"sha256", info["input"]["sha256"]}}},
                     {"open", {{"selection", "resn CYS"}}}}
                    .dump());
  const fs::path file = folder_ / "s.png";
  const Outcome outcome = run("screenshot --session '" + session.string() +
                              "' --size 160x100 -o '" + file.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto texts = texts_of(contents(file));
  const auto named = texts.find("alphascope:selection_expression");
  ASSERT_NE(named, texts.end());
  EXPECT_EQ(named->second, "resn CYS");
  const Outcome both =
      run("screenshot --session '" + session.string() + "' --alpha 1 -o '" + file.string() + "'");
  EXPECT_EQ(both.code, 2);
  EXPECT_TRUE(contains(both.err, "the session already has the setting of --alpha")) << both.err;
}

TEST_F(CliPictures, HaveLabelsAndMeasurements) {
  const std::string molecule = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
  const auto drawn = [&](const std::string& options) {
    const fs::path file = folder_ / "labels.png";
    const Outcome outcome = run("screenshot '" + molecule + "' --alpha 0 --size 320x200 " +
                                options + " -o '" + file.string() + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return pixels(contents(file));
  };
  const std::string plain = drawn("");
  const std::string labels = drawn("--labels 'name SG=name; resn TYR=residue'");
  const std::string measured = drawn("--measure 'A:CYS 3:SG; A:CYS 40:SG'");
  EXPECT_NE(labels, plain);
  EXPECT_NE(measured, plain);
  EXPECT_NE(measured, labels);
  EXPECT_NE(drawn("--measure 'A:CYS 3:SG; A:CYS 40:SG,A:CYS 4:SG; A:CYS 32:SG'"), measured);
  const auto told = [&](const std::string& options) {
    const Outcome wrong = run("screenshot '" + molecule + "' --alpha 0 -o x.png " + options);
    EXPECT_EQ(wrong.code, 2);
    return wrong.err;
  };
  EXPECT_TRUE(contains(told("--labels 'resn HEM=name'"), "no atom matches \"resn HEM\""));
  EXPECT_TRUE(contains(told("--labels 'name SG=colour'"),
                       "labels are name, residue, address, element, radius, b_factor"));
  EXPECT_TRUE(contains(told("--measure 'A:CYS 3:SG'"), "Two atoms have a distance"));
  EXPECT_TRUE(contains(told("--measure 'A:CYS 3:SG; A:CYS 3:XX'"), "no atom \"A:CYS 3:XX\""));
}

}  // namespace
}  // namespace alphascope::testing
