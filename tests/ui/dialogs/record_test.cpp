// SPDX-License-Identifier: GPL-3.0-or-later
// Tests recordings of the window: frames of sweeps and turntables, while the window goes on
// working.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fake_ffmpeg.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/picture/record_frames.hpp"

namespace alphascope::testing {
namespace {

class RecordTest : public ViewerTest {
 protected:
  RecordTest() { open_crambin(); }
  std::string frame(int number) { return bytes("f-" + std::to_string(number) + ".png"); }
  void record(const std::string& what) {
    run("file.record \"" + (folder_ / "f-%d.png").string() + "\" " + what + "\nwait-idle\n");
    EXPECT_EQ(viewer_->state().error, "");
  }
  int frames() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().filename().string().starts_with("f-");
    }
    return count;
  }
};

TEST_F(RecordTest, EachFrameOfASweepIsTheSavedPictureOfItsAlpha) {
  run("alpha.set 3\nwait-idle\n");
  record("alpha=0:2:3 240 160 usual");
  ASSERT_EQ(frames(), 3);
  for (int k = 0; k < 3; ++k) {
    auto texts = texts_of(frame(k + 1));
    EXPECT_EQ(texts["alphascope:alpha_angstrom2"], std::to_string(k));
    EXPECT_EQ(texts["alphascope:frame"], std::to_string(k + 1) + " of 3");
    EXPECT_EQ(texts["alphascope:hash"], hash_text(expected(k).hash));
  }
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3) << "the window stays as it is";
  run("alpha.set 1\nwait-idle\nfile.save_picture \"" + (folder_ / "one.png").string() +
      "\" 240 160 usual\nwait-idle\n");
  EXPECT_EQ(pixels_of(frame(2)).rgba, pixels_of(bytes("one.png")).rgba);
  EXPECT_NE(pixels_of(frame(1)).rgba, pixels_of(frame(2)).rgba);
}

// The window draws labels, so the window itself goes through the sweep.
TEST_F(RecordTest, FramesOfASweepHaveWhatPagesDraw) {
  run("alpha.set 3\nlabel.atoms residue resi 1-3\nwait-idle\n");
  const std::string undo = viewer_->state().undo_text;
  record("alpha=0:2:3 240 160 usual");
  ASSERT_EQ(frames(), 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(texts_of(frame(k + 1))["alphascope:hash"], hash_text(expected(k).hash));
  }
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
  EXPECT_EQ(viewer_->state().undo_text, undo) << "it is no change of the user's";
  run("alpha.set 1\nwait-idle\nfile.save_picture \"" + (folder_ / "one.png").string() +
      "\" 240 160 usual\nwait-idle\n");
  EXPECT_EQ(pixels_of(frame(2)).rgba, pixels_of(bytes("one.png")).rgba);
  run("label.remove_all\nwait-idle\nfile.save_picture \"" + (folder_ / "plain.png").string() +
      "\" 240 160 usual\nwait-idle\n");
  EXPECT_NE(pixels_of(frame(2)).rgba, pixels_of(bytes("plain.png")).rgba);
}

TEST_F(RecordTest, ASweepThatIsDisturbedSaysSo) {
  run("label.atoms residue resi 1-3\nwait-idle\n");
  run("file.record \"" + (folder_ / "f-%d.png").string() +
      "\" alpha=0:2:200 240 160 usual\nframes 10\nalpha.set 7\nwait-idle\n");
  EXPECT_EQ(viewer_->state().error_title, "The sweep was not recorded");
  EXPECT_NE(viewer_->state().error.find("alpha was changed"), std::string::npos);
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 7);
  EXPECT_LT(frames(), 200);
}

TEST_F(RecordTest, ATurntableBeginsWithWhatIsOnScreen) {
  record("180:3 240 160 none");
  ASSERT_EQ(frames(), 3);
  run("file.save_picture \"" + (folder_ / "one.png").string() + "\" 240 160 none\nwait-idle\n");
  EXPECT_EQ(pixels_of(frame(1)).rgba, pixels_of(bytes("one.png")).rgba);
  EXPECT_NE(pixels_of(frame(2)).rgba, pixels_of(frame(1)).rgba);
  EXPECT_NE(pixels_of(frame(3)).rgba, pixels_of(frame(1)).rgba);
}

TEST_F(RecordTest, TheDialogAsksForAllOfItAndRecords) {
  ViewState& m = viewer_->state();
  m.record.path = (folder_ / "f-%d.png").string();
  m.record.options.width = m.record.options.height = 64;
  m.record.recording.frames = 2;
  run("file.record\nframes 2\nclick record.kind.1\nframes 2\nclick record.axis.3\nframes 2\n"
      "click record.there_and_back\nframes 2\n");
  EXPECT_EQ(m.record.recording.kind, RecordingKind::turntable);
  EXPECT_EQ(m.record.recording.axis, TurnAxis::z);
  EXPECT_TRUE(m.record.recording.there_and_back);
  run("click record.ok\nwait-idle\n");
  EXPECT_FALSE(m.record.show);
  EXPECT_EQ(frames(), 2);
}

TEST_F(RecordTest, TheDialogSaysThatMoviesNeedFfmpeg) {
  const FakeFfmpeg none(folder_, "");
  ViewState& m = viewer_->state();
  m.record.path = (folder_ / "m.mp4").string();
  run("file.record\nframes 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("record.no_ffmpeg"));
  run("click record.format.0\nframes 3\n");
  EXPECT_FALSE(viewer_->widgets().contains("record.no_ffmpeg"));
  EXPECT_EQ(fs::path(m.record.path).filename(), "m-%04d.png");
}

TEST_F(RecordTest, ACancelledMovieIsNotThereAndFinishedFramesAre) {
  const FakeFfmpeg counting(folder_, "wc -c > \"$file\"");
  run("file.record \"" + (folder_ / "m.mp4").string() + "\" alpha=0:2:2000 64 64\nframes 5\n");
  EXPECT_NE(file_job(viewer_->state().jobs), nullptr);
  viewer_->calls().jobs.cancel(JobId::picture);
  run("wait-idle\n");
  EXPECT_NE(viewer_->state().notice.text().find("m.mp4 was not written"), std::string::npos)
      << viewer_->state().notice.text();
  EXPECT_FALSE(fs::exists(folder_ / "m.mp4"));
}

TEST_F(RecordTest, WhatCannotBeIsRefused) {
  const auto why = [&](const std::string& words) {
    return viewer_->commands().run_line("file.record " + words).why;
  };
  EXPECT_NE(why("f.png alpha=0:1:2").find("exactly one place"), std::string::npos);
  EXPECT_NE(why("f-%d.png alpha=2:1:2").find("from 1 to 2 Å² instead"), std::string::npos);
  EXPECT_NE(why("f-%d.png 360").find("such as 360:120"), std::string::npos);
  viewer_->step(nullptr);
  EXPECT_EQ(file_job(viewer_->state().jobs), nullptr);
}

TEST(TurnedView, KeepsItsDistanceAndTurnsAboutTheAxis) {
  const Viewpoint view{{10, 2, 30}, {1, 2, 3}, {0, 1, 0.2}, 0.5};
  for (const TurnAxis axis : {TurnAxis::up, TurnAxis::x, TurnAxis::y, TurnAxis::z}) {
    const Viewpoint turned = turned_view(view, axis, 77);
    double before = 0, after = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      before += std::pow(view.position[k] - view.focal_point[k], 2);
      after += std::pow(turned.position[k] - view.focal_point[k], 2);
      EXPECT_EQ(turned.focal_point[k], view.focal_point[k]);
    }
    EXPECT_NEAR(after, before, 1e-9);
  }
  const Viewpoint z = turned_view(view, TurnAxis::z, 90);
  EXPECT_NEAR(z.position[2], view.position[2], 1e-12);
  EXPECT_NEAR(z.position[1], 2 - 9, 1e-12) << "the camera goes the other way";
}

}  // namespace
}  // namespace alphascope::testing
