// SPDX-License-Identifier: GPL-3.0-or-later
// Tests recordings of a lesson: pictures and movies of each step with its text. Also tests what
// happens to them when they are cancelled or disturbed.
#include <gtest/gtest.h>

#include "app/viewer/resources.hpp"
#include "core/document/picture/recording.hpp"
#include "tests/support/fake_ffmpeg.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/picture/lesson_page.hpp"

namespace alphascope::testing {
namespace {

constexpr const char* kShort = R"(# Short
For tests.
```
molecule two_balls.xyzr
view.from z
```
## One
There are {n edges} at {alpha}.
## Two
The union has a **volume** of {volume}.
```
alpha.set 2
```
## Question
How many?
### Answer
{n edges}.
```
alpha.set -2
```
)";

class LessonRecordTest : public ViewerTest {
 protected:
  LessonRecordTest() {
    std::ofstream(folder_ / "lesson.md") << kShort;
    fs::copy_file(lessons_folder() / "two_balls.xyzr", folder_ / "two_balls.xyzr");
    run("size 760 400\n");
  }
  void open_lesson() { run("lesson.open " + (folder_ / "lesson.md").string() + "\nwait-idle\n"); }
  void record(const std::string& name, const std::string& what) {
    run("file.record \"" + (folder_ / name).string() + "\" " + what + "\nwait-idle\n");
  }
  Image frame(int number) { return pixels_of(bytes("f-" + std::to_string(number) + ".png")); }
  int files() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().filename().string().starts_with("f-");
    }
    return count;
  }
};

Image part_of(const Image& image, int x0, int width) {
  Image part{width, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    const auto* const row = &image.rgba[4 * (std::size_t(y) * image.width + x0)];
    part.rgba.insert(part.rgba.end(), row, row + 4 * std::size_t(width));
  }
  return part;
}

TEST_F(LessonRecordTest, PicturesAreOneAStepWithItsTextBesideTheView) {
  open_lesson();
  run("lesson.next\nwait-idle\n");  // it starts with the first step, wherever the window is
  record("f-%d.png", "lesson:3 960 270 none");  // wider than the window's view
  EXPECT_EQ(viewer_->state().error, "");
  ASSERT_EQ(files(), 4) << "three steps and an answer";
  for (int k = 1; k <= 4; ++k) {
    ASSERT_EQ(frame(k).width, 960);
    ASSERT_EQ(frame(k).height, 270);
  }
  EXPECT_EQ(texts_of(bytes("f-2.png"))["alphascope:lesson"], "Short: Two");
  EXPECT_EQ(texts_of(bytes("f-2.png"))["alphascope:alpha_angstrom2"], "2");
  EXPECT_EQ(texts_of(bytes("f-4.png"))["alphascope:alpha_angstrom2"], "-2");
  const int view = page_view(960, 270).width;
  EXPECT_GT(drawn_pixels(part_of(frame(1), view, 960 - view)), 300) << "there is text";
  EXPECT_GT(
      differing_pixels(part_of(frame(1), view, 960 - view), part_of(frame(2), view, 960 - view)),
      300);
  // The window now shows the last step, with the view of a saved picture.
  run("file.save_picture \"" + (folder_ / "one.png").string() + "\" " + std::to_string(view) +
      " 270 none\nwait-idle\n");
  EXPECT_EQ(part_of(frame(4), 0, view).rgba, pixels_of(bytes("one.png")).rgba);
  EXPECT_NE(part_of(frame(3), 0, view).rgba, pixels_of(bytes("one.png")).rgba);
}

TEST_F(LessonRecordTest, FactsAreInTheTextWhenItsPictureIsTaken) {
  open_lesson();
  record("f-%d.png", "lesson:1 480 270 none");
  // Computing the volume takes a moment, in which the text has “…” in its place. The recorded page
  // must have the number.
  const LessonState& m = viewer_->state().lessons;
  run("lesson.back\nwait-idle\nframes 3\n");
  ASSERT_EQ(m.step, 1u);
  ASSERT_TRUE(m.whole);
  const int view = page_view(480, 270).width;
  const Image black{view, 270, std::vector<std::uint8_t>(4 * std::size_t(view) * 270)};
  std::string left_out;
  const Image expected = lesson_picture(
      black, {"Short", "step 2 of 3", "Two", m.paragraphs, Theme::dark}, 480, 270, left_out);
  EXPECT_EQ(part_of(frame(2), view, 480 - view).rgba, part_of(expected, view, 480 - view).rgba);
}

TEST_F(LessonRecordTest, AMovieHoldsEachStep) {
  const FakeFfmpeg counting(folder_, "wc -c > \"$file\"");
  open_lesson();
  record("m.mp4", "lesson:0.6 64 48");
  EXPECT_EQ(viewer_->state().error, "");
  EXPECT_EQ(frames_held(0.6), 3);
  EXPECT_EQ(std::stoi(bytes("m.mp4")), 4 * 3 * 64 * 48 * 4);
}

TEST_F(LessonRecordTest, ACancelledOneLeavesNoHalfMovie) {
  const FakeFfmpeg counting(folder_, "wc -c > \"$file\"");
  open_lesson();
  run("file.record \"" + (folder_ / "m.mp4").string() + "\" lesson:600 64 48\nframes 8\n");
  EXPECT_TRUE(file_job(viewer_->state().jobs) != nullptr);
  viewer_->calls().jobs.cancel(JobId::picture);
  run("wait-idle\n");
  EXPECT_NE(viewer_->state().notice.text().find("m.mp4 was not written"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "m.mp4"));
}

TEST_F(LessonRecordTest, LeavingTheLessonEndsIt) {
  const FakeFfmpeg counting(folder_, "wc -c > \"$file\"");
  open_lesson();
  run("file.record \"" + (folder_ / "m.mp4").string() +
      "\" lesson:600 64 48\nframes 2\nlesson.close\nwait-idle\n");
  EXPECT_NE(viewer_->state().error.find("The recording ended because"), std::string::npos)
      << viewer_->state().error;
  EXPECT_FALSE(fs::exists(folder_ / "m.mp4"));
}

TEST_F(LessonRecordTest, WhatCannotBeIsRefused) {
  open_crambin();
  const auto why = [&](const std::string& words) {
    return viewer_->commands().run_line("file.record " + words).why;
  };
  EXPECT_EQ(why("f-%d.png lesson:10"), "No lesson is open.");
  EXPECT_NE(why("f-%d.png lesson").find("such as lesson:10"), std::string::npos);
  EXPECT_NE(why("f-%d.png lesson:0").find("0.2 to 600 s"), std::string::npos);
}

TEST_F(LessonRecordTest, TheDialogRecordsTheOpenLesson) {
  RecordState& m = viewer_->state().record;
  m.options.width = m.options.height = 64;
  open_crambin();
  run("file.record\nframes 2\nclick record.kind.2\nframes 2\n");
  EXPECT_TRUE(viewer_->widgets().contains("record.no_lesson"));
  run("click record.cancel\nframes 2\n");
  open_lesson();
  m.path = (folder_ / "f-%d.png").string();  // another molecule has another name
  run("file.record\nframes 2\n");
  EXPECT_FALSE(viewer_->widgets().contains("record.no_lesson"));
  run("click record.ok\nwait-idle\n");
  EXPECT_EQ(files(), 4);
}

TEST(LessonRecordOptions, ARecordingNeedsALesson) {
  const char* const wrong[] = {"alphascope", "--record", "out.mp4"};
  EXPECT_EQ(parse_options(3, wrong).exit_code, 2);
  const char* const right[] = {"alphascope",       "--record", "out.mp4",       "--lesson", "x",
                               "--record-seconds", "2.5",      "--record-size", "640x480"};
  const ParsedOptions parsed = parse_options(9, right);
  ASSERT_FALSE(parsed.exit_code) << parsed.text;
  EXPECT_EQ(parsed.options.record_seconds, 2.5);
  EXPECT_EQ(parsed.options.record_width, 640);
}

TEST(LessonPicture, LongTextHasSmallerLettersAndTellsWhenItIsCut) {
  const PageView size = page_view(640, 360);
  const Image view{size.width, size.height,
                   std::vector<std::uint8_t>(4 * std::size_t(size.width) * size.height, 255)};
  const auto page = [](int sentences) {
    LessonPage page{"Chapter", "step 1 of 2", "Title", {}, Theme::light};
    for (int k = 0; k < sentences; ++k) page.text.push_back({"Some words that are read.", k > 0});
    return page;
  };
  std::string left_out;
  lesson_picture(view, page(3), 640, 360, left_out);
  lesson_picture(view, page(14), 640, 360, left_out);
  EXPECT_EQ(left_out, "");
  lesson_picture(view, page(80), 640, 360, left_out);
  EXPECT_NE(left_out.find("is cut off"), std::string::npos);
}

}  // namespace
}  // namespace alphascope::testing
