// SPDX-License-Identifier: GPL-3.0-or-later
// Tests movies: whole or not at all, whatever ffmpeg does.
#include "core/write/movie_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "core/run/child_program.hpp"
#include "tests/support/fake_ffmpeg.hpp"

namespace alphascope::testing {
namespace {

namespace fs = std::filesystem;

class Movie : public ::testing::Test {
 protected:
  Movie()
      : folder_(fs::path(::testing::TempDir()) / ("alphascope_movie_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Movie() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ifstream file(movie_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  // Counts the files in the folder except the movie.
  int left_behind() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.is_regular_file() && entry.path() != movie_;
    }
    return count;
  }
  // The message of the exception thrown while a movie is made.
  std::string failure() {
    try {
      MovieFile movie(movie_, options_);
      for (int k = 0; k < 200; ++k) movie.add(frame_, {});
      movie.commit({});
    } catch (const WriteError& error) {
      return error.what();
    }
    return "(none)";
  }

  fs::path folder_;
  fs::path movie_ = folder_ / "a movie.mp4";
  MovieOptions options_{MovieFormat::mp4, 63, 41, 25, false, {{"comment", "alpha 1.4"}}};
  std::vector<std::uint8_t> frame_ = std::vector<std::uint8_t>(63 * 41 * 4, 100);
};

TEST_F(Movie, HasEveryFrameAndIsThereOnlyWhenItIsWhole) {
  const FakeFfmpeg ffmpeg(
      folder_, "echo \"$@\" > '" + (folder_ / "bin/asked").string() + "'; wc -c > \"$file\"");
  std::ofstream(movie_) << "older";
  {
    MovieFile movie(movie_, options_);
    for (int k = 0; k < 3; ++k) movie.add(frame_, {});
    EXPECT_EQ(text(), "older");
    movie.commit({});
  }
  EXPECT_EQ(std::stoul(text()), 3 * frame_.size());
  EXPECT_EQ(left_behind(), 0);
  std::ifstream asked(folder_ / "bin/asked");
  const std::string words{std::istreambuf_iterator<char>(asked), {}};
  for (const char* word : {"-s 63x41", "-r 25", "libx264", "comment=alpha 1.4", "-f mp4 file:"}) {
    EXPECT_NE(words.find(word), std::string::npos) << words;
  }
}

TEST_F(Movie, ThatFfmpegCannotMakeSaysCodecAndReason) {
  std::ofstream(movie_) << "older";
  for (const char* script :
       {"echo 'Unknown encoder' >&2; exit 1",
        "cat > \"$file\"; echo warning >&2; echo 'No space left on device' >&2; exit 1",
        // ffmpeg 5.1 does this.
        "cat > \"$file\"; echo 'Error closing file: No space left on device' >&2; exit 0"}) {
    const FakeFfmpeg ffmpeg(folder_, script);
    const std::string said = failure();
    EXPECT_NE(said.find("a movie.mp4"), std::string::npos) << said;
    EXPECT_NE(said.find("libx264"), std::string::npos) << said;
    const bool last = said.find("Unknown encoder") != std::string::npos ||
                      said.find("No space left on device") != std::string::npos;
    EXPECT_TRUE(last && said.find("warning") == std::string::npos) << said;
    EXPECT_EQ(text(), "older");
    EXPECT_EQ(left_behind(), 0);
  }
}

TEST_F(Movie, WithoutFfmpegSaysHowToGetIt) {
  const FakeFfmpeg ffmpeg(folder_, "");
  EXPECT_NE(failure().find("apt install ffmpeg"), std::string::npos);
  EXPECT_EQ(left_behind(), 0);
}

TEST_F(Movie, ThatIsCancelledLeavesNothing) {
  const FakeFfmpeg ffmpeg(folder_, "echo begun > \"$file\"; sleep 100");
  const CancelToken token;
  {
    MovieFile movie(movie_, options_);
    movie.add(frame_, token);
    token.cancel();
    EXPECT_THROW(movie.commit(token), Cancelled);
  }
  EXPECT_FALSE(fs::exists(movie_));
  EXPECT_EQ(left_behind(), 0);
}

TEST_F(Movie, TransparentIsNoMp4) {
  options_.transparent = true;
  EXPECT_THROW(MovieFile(movie_, options_), std::invalid_argument);
}

TEST_F(Movie, ByTheRealFfmpegIsReadByFfprobe) {
  if (!find_program("ffmpeg") || !find_program("ffprobe")) {
    GTEST_SKIP() << "ffmpeg is not installed, which is optional";
  }
  for (const MovieFormat format : {MovieFormat::mp4, MovieFormat::webm}) {
    options_.format = format;
    movie_ = folder_ / (format == MovieFormat::mp4 ? "m.mp4" : "m.webm");
    MovieFile movie(movie_, options_);
    for (int k = 0; k < 10; ++k) movie.add(frame_, {});
    movie.commit({});
    const std::string command =
        "ffprobe -v error -count_frames -show_entries "
        "stream=codec_name,width,height,nb_read_frames,r_frame_rate -of csv=p=0 '" +
        movie_.string() + "' > '" + (folder_ / "probe").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream probe(folder_ / "probe");
    const std::string said{std::istreambuf_iterator<char>(probe), {}};
    const std::string codec = format == MovieFormat::mp4 ? "h264" : "vp9";
    EXPECT_EQ(said, codec + ",64,42,25/1,10\n");
    fs::remove(folder_ / "probe");
    EXPECT_EQ(left_behind(), format == MovieFormat::mp4 ? 0 : 1);
  }
}

}  // namespace
}  // namespace alphascope::testing
