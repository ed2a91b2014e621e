// Pictures of alphascope-cli: what is written over and into them.
#include "tests/app/cli_fixture.hpp"
#include "tests/support/png_chunks.hpp"

namespace alphascope::testing {
namespace {

class CliPictures : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!kDrawsPictures) GTEST_SKIP() << "built without the renderer";
  }
  std::string picture(const std::string& options) const {
    const fs::path file = folder_ / "it's one.png";
    const Outcome outcome = run("screenshot '" + cube_.string() + "' --alpha 1 --size 320x200 " +
                                options + " -o \"" + file.string() + "\"");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return contents(file);
  }
};

TEST_F(CliPictures, HaveACaptionOnlyWhenItIsAskedFor) {
  const auto pixels = [](const std::string& png) {
    std::string all;
    for (const auto& [type, data] : chunks_of(png)) {
      if (type == "IDAT") all += data;
    }
    return all;
  };
  const std::string plain = pixels(picture(""));
  EXPECT_EQ(pixels(picture("--caption none")), plain);
  EXPECT_NE(pixels(picture("--caption alpha")), plain);
  EXPECT_NE(pixels(picture("--caption alpha")), pixels(picture("--caption hash")));
  const Outcome wrong =
      run("screenshot '" + cube_.string() + "' --alpha 1 -o x.png --caption blue");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "\"blue\" is no part of a caption")) << wrong.err;
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

}  // namespace
}  // namespace alphascope::testing
