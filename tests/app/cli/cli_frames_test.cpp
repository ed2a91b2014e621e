// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli frames: its files and its messages.
#include <set>

#include "core/run/child_program.hpp"
#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/fake_ffmpeg.hpp"
#include "tests/support/png_chunks.hpp"

namespace alphascope::testing {
namespace {

class CliFrames : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!kDrawsPictures) GTEST_SKIP() << "built without the renderer";
  }
  std::string line(const std::string& options, const std::string& out) const {
    const bool sized = contains(options, "--size");
    return "frames '" + cube_.string() + "' --preset fast " + (sized ? "" : "--size 160x100 ") +
           options + " -o '" + (folder_ / out).string() + "'";
  }
  Outcome frames(const std::string& options, const std::string& out = "f-%02d.png") const {
    return run(line(options, out));
  }
  std::string frame(int number) const {
    return contents(folder_ / ("f-0" + std::to_string(number) + ".png"));
  }
  static std::string pixels(const std::string& png) {
    std::string all;
    for (const auto& [type, data] : chunks_of(png)) {
      if (type == "IDAT") all += data;
    }
    return all;
  }
  int pictures() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().extension() == ".png" || entry.path().extension() == ".tmp";
    }
    return count;
  }
};

TEST_F(CliFrames, EachFrameOfASweepIsTheScreenshotOfItsAlpha) {
  const Outcome swept = frames("--sweep alpha=-1:2:4");
  ASSERT_EQ(swept.code, 0) << swept.err;
  EXPECT_EQ(pictures(), 4);
  std::set<std::string> different;
  for (int k = 1; k <= 4; ++k) {
    auto texts = texts_of(frame(k));
    EXPECT_EQ(texts["alphascope:alpha_angstrom2"], std::to_string(k - 2)) << k;
    EXPECT_EQ(texts["alphascope:frame"], std::to_string(k) + " of 4");
    EXPECT_TRUE(contains(texts["alphascope:command"], "--sweep alpha=-1:2:4"));
    different.insert(pixels(frame(k)));
    const json computed = compute_json("'" + cube_.string() + "' --alpha=" + std::to_string(k - 2));
    EXPECT_EQ(texts["alphascope:hash"], computed["hash"]) << k;
  }
  EXPECT_EQ(different.size(), 4u);
  const Outcome one = run("screenshot '" + cube_.string() +
                          "' --size 160x100 --preset fast --alpha 1 --caption usual -o '" +
                          (folder_ / "one.png").string() + "'");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(pixels(frame(3)), pixels(contents(folder_ / "one.png")));
}

TEST_F(CliFrames, ATurntableBeginsWithTheScreenshotAndTurns) {
  for (const char* axis : {"up", "x", "y", "z"}) {
    const Outcome turned =
        frames("--turntable 90:3 --alpha 1 --caption none --axis " + std::string(axis));
    ASSERT_EQ(turned.code, 0) << turned.err;
    EXPECT_EQ(texts_of(frame(3))["alphascope:turned_degrees"], "90");
    const Outcome one =
        run("screenshot '" + cube_.string() + "' --size 160x100 --preset fast --alpha 1 -o '" +
            (folder_ / "one.png").string() + "'");
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(pixels(frame(1)), pixels(contents(folder_ / "one.png"))) << axis;
    EXPECT_NE(pixels(frame(2)), pixels(frame(1))) << axis;
    EXPECT_NE(pixels(frame(3)), pixels(frame(2))) << axis;
  }
}

TEST_F(CliFrames, VerboseSaysTheTimesOfEachFrame) {
  const Outcome told = frames("-v --sweep alpha=0:1:2 --there-and-back");
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.err, "frame 1 of 2, alpha 0 Å²: computed in ")) << told.err;
  EXPECT_TRUE(contains(told.err, "frame 2 of 2, alpha 1 Å²: computed in ")) << told.err;
}

TEST_F(CliFrames, WhatCannotBeIsRefusedBeforeAnythingIsWritten) {
  const std::pair<const char*, const char*> wrong[] = {
      {"--sweep alpha=0:1:0", "whole number from 1 to 20000"},
      {"--sweep alpha=0:1:1000000", "whole number from 1 to 20000"},
      {"--sweep alpha=2:1:5", "from 1 to 2 Å² instead"},
      {"--sweep alpha=0:1:2 --alpha 1", "--sweep sets alpha"},
      {"--sweep alpha=0:1:2 --turntable 360:2", "choose one"},
      {"--alpha 1", "--sweep or --turntable is required"},
      {"--turntable 360:2", "--alpha is required"},
      {"--turntable 360:2 --alpha 1 --sweep-scale log", "belongs to --sweep"},
      {"--sweep alpha=0:1:2 --axis x", "belongs to --turntable"},
      {"--sweep alpha=0:1:2 --fps 0", "--fps"},
      {"--sweep alpha=0:1:2 --size 0x0", "--size takes WIDTHxHEIGHT"},
      {"--sweep alpha=0:1:2 --size 0x0", "from 16 to 16384 pixels"},
      {"--sweep alpha=0:1:2 --size 100000x100", "out of range"}};
  for (const auto& [options, message] : wrong) {
    const Outcome outcome = frames(options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_TRUE(contains(outcome.err, message)) << options << ": " << outcome.err;
  }
  const std::pair<const char*, const char*> names[] = {
      {"frame.png", "exactly one place for their number"},
      {"frame-%d-%d.png", "exactly one place for their number"},
      {"frame.avi", "(.mp4, .webm)"}};
  for (const auto& [out, message] : names) {
    const Outcome outcome = frames("--sweep alpha=0:1:2", out);
    EXPECT_EQ(outcome.code, 2) << out;
    EXPECT_TRUE(contains(outcome.err, message)) << out << ": " << outcome.err;
  }
  EXPECT_TRUE(contains(frames("--sweep alpha=0:1:2 --transparent", "a.mp4").err, ".webm"));
  const Outcome nowhere = frames("--sweep alpha=0:1:2", "no/such/f-%d.png");
  EXPECT_EQ(nowhere.code, 5) << nowhere.err;
  EXPECT_EQ(pictures(), 0);
}

TEST_F(CliFrames, NoFrameReplacesWhatIsRead) {
  fs::copy_file(cube_, folder_ / "f-02.png");
  const Outcome outcome =
      run("frames '" + (folder_ / "f-02.png").string() +
          "' --format xyzr --sweep alpha=0:1:3 -o '" + (folder_ / "f-%02d.png").string() + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "which is read")) << outcome.err;
  EXPECT_EQ(contents(folder_ / "f-02.png"), contents(cube_));
}

TEST_F(CliFrames, MoviesNeedFfmpegAndSaySo) {
  {
    const FakeFfmpeg none(folder_, "");
    const Outcome outcome = frames("--sweep alpha=0:1:2", "m.mp4");
    EXPECT_EQ(outcome.code, 5);
    EXPECT_TRUE(contains(outcome.err, "apt install ffmpeg")) << outcome.err;
  }
  {
    const FakeFfmpeg failing(folder_, "echo 'Unknown encoder' >&2; exit 1");
    const Outcome outcome = frames("--sweep alpha=0:1:2", "m.webm");
    EXPECT_EQ(outcome.code, 5);
    EXPECT_TRUE(contains(outcome.err, "libvpx-vp9: Unknown encoder")) << outcome.err;
  }
  {
    const FakeFfmpeg counting(folder_, "wc -c > \"$file\"");
    const Outcome outcome = frames("--turntable 360:3 --alpha 1", "m.mp4");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(std::stoi(contents(folder_ / "m.mp4")), 3 * 160 * 100 * 4);
    EXPECT_TRUE(contains(outcome.out, "3 frames, 160 x 100, 0.1 s")) << outcome.out;
  }
  EXPECT_EQ(pictures(), 0);
}

TEST_F(CliFrames, ARealMovieIsReadByFfprobe) {
  if (!find_program("ffmpeg") || !find_program("ffprobe")) {
    GTEST_SKIP() << "ffmpeg is not installed, which is optional";
  }
  const Outcome outcome = frames("--sweep alpha=0:1:5 --fps 10 --size 161x101", "m.mp4");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string probe =
      "ffprobe -v error -count_frames -show_entries "
      "stream=width,height,nb_read_frames -of csv=p=0 '" +
      (folder_ / "m.mp4").string() + "' > '" + (folder_ / "said").string() + "'";
  ASSERT_EQ(std::system(probe.c_str()), 0);
  EXPECT_EQ(contents(folder_ / "said"), "162,102,5\n");
}

}  // namespace
}  // namespace alphascope::testing
