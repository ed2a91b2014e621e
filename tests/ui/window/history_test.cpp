// SPDX-License-Identifier: GPL-3.0-or-later
// Tests undo and redo in the whole window. Hash and picture come back, a drag is one entry, and
// playback makes none.
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class HistoryTest : public ViewerTest {
 protected:
  std::string hash() {
    run("wait-idle\n");
    return hash_text(viewer_->state().result->complex.hash);
  }
  void undo() { run("edit.undo\nwait-idle\n"); }
  void redo() { run("edit.redo\nwait-idle\n"); }
};

TEST_F(HistoryTest, UndoRestoresHashAndPicture) {
  open_crambin();
  run("click alpha.preset.1.4\nwait-idle\n");
  const std::string before = hash();
  const Image picture_before = picture();
  run("click alpha.preset.3\nwait-idle\n");
  const std::string after = hash();
  ASSERT_NE(before, after);
  EXPECT_EQ(viewer_->state().undo_text, "alpha");
  undo();
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 1.4);
  EXPECT_EQ(picture().rgba, picture_before.rgba);
  redo();
  EXPECT_EQ(hash(), after);
  EXPECT_NE(picture().rgba, picture_before.rgba);
}

TEST_F(HistoryTest, ADragIsOneEntryAndTwoDragsAreTwo) {
  open_crambin();
  run("move alpha.slider 0.3\ndown\nmove alpha.slider 0.5\nmove alpha.slider 0.6\nup\n");
  const double first = viewer_->state().settings.request.alpha_angstrom2;
  run("move alpha.slider 0.6\ndown\nmove alpha.slider 0.7\nmove alpha.slider 0.9\nup\n");
  EXPECT_GT(viewer_->state().settings.request.alpha_angstrom2, first);
  undo();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, first);
  undo();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0);
  EXPECT_EQ(viewer_->state().undo_text, "");
}

TEST_F(HistoryTest, EachTapIsAnEntryAndKeysUndo) {
  open_crambin();
  run("key right\nkey right\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().settings.request.alpha_angstrom2, 0.2);
  run("key ctrl+z\n");
  EXPECT_DOUBLE_EQ(viewer_->state().settings.request.alpha_angstrom2, 0.1);
  run("key ctrl+y\nwait-idle\n");
  EXPECT_DOUBLE_EQ(viewer_->state().settings.request.alpha_angstrom2, 0.2);
}

TEST_F(HistoryTest, PlaybackLeavesNoEntry) {
  open_crambin();
  run("click alpha.preset.1.4\nwait-idle\nclick alpha.play\nframes 30\n");
  run("click alpha.play\nwait-idle\n");
  EXPECT_GT(viewer_->state().settings.request.alpha_angstrom2, 1.4);
  undo();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0);
}

TEST_F(HistoryTest, AtomsAndDisplayComeBack) {
  open_crambin();
  const std::size_t all = viewer_->state().molecule.balls;
  viewer_->state().settings.open.balls.selection = "resi 1-20";
  run("frames 1\nwait-idle\n");
  const std::size_t some = viewer_->state().molecule.balls;
  ASSERT_LT(some, all);
  viewer_->state().settings.display.balls = false;
  run("frames 1\n");
  EXPECT_EQ(viewer_->state().undo_text, "balls");
  undo();
  EXPECT_TRUE(viewer_->state().settings.display.balls);
  EXPECT_EQ(viewer_->state().undo_text, "choice of atoms");
  undo();
  EXPECT_EQ(viewer_->state().molecule.balls, all);
  EXPECT_EQ(viewer_->state().settings.open.balls.selection, "");
  redo();
  EXPECT_EQ(viewer_->state().molecule.balls, some);
}

TEST_F(HistoryTest, ARefusedChangeLeavesNoEntry) {
  open_crambin();
  run("click alpha.preset.3\nwait-idle\n");
  viewer_->state().settings.open.radii_table = folder_ / "there is none";
  viewer_->state().settings.open.balls.radii = RadiiSet::user;
  run("frames 1\nwait-idle\nclick error.ok\n");
  EXPECT_EQ(viewer_->state().undo_text, "alpha");
}

TEST_F(HistoryTest, AnotherFileStartsAnew) {
  open_crambin();
  run("click alpha.preset.3\nwait-idle\n");
  ASSERT_EQ(viewer_->state().undo_text, "alpha");
  const fs::path other = folder_ / "other.pdb";
  fs::copy_file(crambin(), other);
  run("open " + other.string() + "\nwait-idle\n");
  EXPECT_EQ(viewer_->state().undo_text, "");
  EXPECT_FALSE(viewer_->commands().run("edit.undo").done());
  viewer_->undo();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
}

}  // namespace
}  // namespace alphascope::testing
