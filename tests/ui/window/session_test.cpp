// SPDX-License-Identifier: GPL-3.0-or-later
// Tests sessions in the whole window. After saving, restarting the program and opening, picture and
// hash are the same.
#include "core/files/file_hash.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class SessionWindowTest : public ViewerTest {
 protected:
  SessionWindowTest() { fs::copy_file(crambin(), molecule()); }
  fs::path molecule() const { return folder_ / "m.pdb"; }
  fs::path session() const { return folder_ / "s.json"; }
  void reset_for_molecule() {
    viewer_.reset();
    host_ = make_egl_host({1100, 700, 1, "test"});
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    viewer_ = std::make_unique<Viewer>(*host_, options);
  }
  std::string hash() const { return hash_text(viewer_->state().result->complex.hash); }
  void open_molecule() { run("open " + molecule().string() + "\nwait-idle\n"); }
  void save() { run("file.save_session " + session().string() + "\nwait-idle\n"); }
  void open_session() { run("file.open_session " + session().string() + "\nwait-idle\n"); }
  std::string text() { return bytes("s.json"); }
  void replace(const std::string& from, const std::string& to) {
    std::string changed = text();
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    changed.replace(changed.find(from), from.size(), to);
    std::ofstream(session()) << changed;
  }
};

TEST_F(SessionWindowTest, TheSamePictureAndHashInANewWindow) {
  open_molecule();
  viewer_->state().settings.open.balls.selection = "resi 1-30";
  viewer_->state().settings.display.edges = viewer_->state().settings.display.grown_balls = true;
  viewer_->state().settings.display.ball_opacity = 0.5f;
  viewer_->state().window.picture.caption = read_caption_parts("hash");
  viewer_->state().record.recording.frames = 17;
  run("wait-idle\nalpha.set 2.5\nsolvent.set 0.3\nview.light_theme on\nselect.atoms A:15\n"
      "click bottom.signature\nclick display\nmove view 0.4 0.5\ndown\nmove view 0.7 0.6\nup\n"
      "wheel 3\nalpha.scale root\nwait-idle\n");
  save();
  const std::string before = hash();
  const Image picture_before = picture();
  const std::string saved = text();
  reset_for_molecule();
  open_session();
  EXPECT_EQ(viewer_->state().error, "");
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(picture().rgba, picture_before.rgba);
  EXPECT_EQ(viewer_->state().window.page, "signature");
  EXPECT_TRUE(viewer_->state().window.closed_sections.contains("display"));
  EXPECT_TRUE(viewer_->state().window.picture.caption.has(CaptionPart::hash));
  EXPECT_EQ(viewer_->state().record.recording.frames, 17);
  EXPECT_EQ(viewer_->state().settings.selection.items.size(), 7u);
  EXPECT_EQ(viewer_->state().undo_text, "") << "a session begins its own history";
  save();
  EXPECT_EQ(text(), saved) << "what is saved again is the same file";
}

TEST_F(SessionWindowTest, TheWindowIsBusyUntilItIsSaved) {
  open_molecule();
  run("wait-idle\n");
  viewer_->calls().files.save_session(session());
  viewer_->step(nullptr);
  EXPECT_TRUE(viewer_->busy()) << "scripts wait for the file";
  run("wait-idle\n");
  EXPECT_TRUE(std::filesystem::exists(session()));
}

TEST_F(SessionWindowTest, AnythingElseInTheFileChangesThePicture) {
  open_molecule();
  save();
  const Image picture_before = picture();
  replace("\"ball_scale\": 0.3", "\"ball_scale\": 0.4");
  open_session();
  EXPECT_NE(picture().rgba, picture_before.rgba);
}

TEST_F(SessionWindowTest, AWrongValueLeavesTheWindowAsItIs) {
  open_molecule();
  save();
  run("alpha.set 3\nwait-idle\n");
  replace("\"alpha_angstrom2\": 0.0", "\"alpha_angstrom2\": \"x\"");
  run("file.open_session " + session().string() + "\nwait-idle\n");
  EXPECT_EQ(viewer_->state().error_title, "The session cannot be opened");
  EXPECT_NE(viewer_->state().error.find("s.json, line "), std::string::npos);
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
  EXPECT_EQ(viewer_->state().undo_text, "alpha");
  EXPECT_EQ(viewer_->state().molecule.name, "m.pdb");
}

TEST_F(SessionWindowTest, AMoleculeThatMovedIsAskedForAndFound) {
  open_molecule();
  run("alpha.set 3\nwait-idle\n");
  save();
  const std::string before = hash();
  fs::rename(molecule(), folder_ / "elsewhere.pdb");
  reset_for_molecule();
  open_session();
  ASSERT_TRUE(viewer_->state().session_problem.has_value());
  EXPECT_NE(viewer_->state().session_problem->text.find(molecule().string()), std::string::npos);
  EXPECT_FALSE(viewer_->state().session_problem->can_open);
  EXPECT_FALSE(viewer_->state().molecule.loaded);
  viewer_->state().browser.folder = folder_;
  run("frames 3\nclick session.choose\nwait-idle\ndouble-click browser.entry.elsewhere.pdb\n"
      "wait-idle\n");
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(viewer_->state().drop_note, "");
}

TEST_F(SessionWindowTest, AMoleculeThatChangedIsOpenedOnlyWhenAsked) {
  open_molecule();
  save();
  std::ofstream(molecule(), std::ios::app) << "REMARK changed\n";
  reset_for_molecule();
  open_session();
  ASSERT_TRUE(viewer_->state().session_problem.has_value());
  EXPECT_TRUE(viewer_->state().session_problem->can_open);
  run("frames 3\nclick session.cancel\nwait-idle\n");
  EXPECT_FALSE(viewer_->state().molecule.loaded);
  open_session();
  run("frames 3\nclick session.anyway\nwait-idle\n");
  EXPECT_TRUE(viewer_->state().molecule.loaded);
  EXPECT_NE(viewer_->state().drop_note.find("SHA-256"), std::string::npos);
}

TEST_F(SessionWindowTest, AMoleculeThatCannotBeReadLeavesTheWindowAsItIs) {
  open_molecule();
  save();
  const fs::path bad = folder_ / "bad.pdb";
  std::ofstream(bad) << "nothing\n";
  const std::string good_hash = hash_of_file(molecule());
  replace(good_hash, hash_of_file(bad));
  std::ofstream(molecule()) << "nothing\n";
  run("alpha.set 3\nwait-idle\n");
  open_session();
  EXPECT_EQ(viewer_->state().error_title, "The file cannot be opened");
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
  // The next file is no session.
  run("click error.ok\nopen " + crambin().string() + "\nwait-idle\n");
  EXPECT_EQ(viewer_->state().session_file, "");
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
}

TEST_F(SessionWindowTest, WhatIsUnknownIsTold) {
  open_molecule();
  save();
  replace("\"display\": {", "\"display\": { \"glow\": 1,");
  open_session();
  EXPECT_EQ(viewer_->state().error_title, "The session has unknown settings");
  EXPECT_NE(viewer_->state().error.find("\"display.glow\""), std::string::npos);
}

TEST_F(SessionWindowTest, DroppedOrNamedItOpensAsAFileDoes) {
  open_molecule();
  run("alpha.set 3\nwait-idle\n");
  save();
  reset_for_molecule();
  viewer_->open_dropped({session(), molecule()});
  run("wait-idle\n");
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 3);
  EXPECT_EQ(viewer_->state().session_file, session());
}

TEST_F(SessionWindowTest, SavedWhereOneCannotWriteIsTold) {
  open_molecule();
  run("file.save_session /no folder/s.json\nwait-idle\n");
  EXPECT_EQ(viewer_->state().error_title, "The session cannot be saved");
}

TEST_F(SessionWindowTest, TheDialogSavesBesideTheMolecule) {
  open_molecule();
  run("key ctrl+shift+s\nframes 3\nclick save_session.ok\nwait-idle\n");
  EXPECT_TRUE(fs::exists(folder_ / "m.json"));
  EXPECT_NE(viewer_->state().notice.text().find("m.json"), std::string::npos);
}

// The command line's picture of a session equals the one that the window saves.
TEST_F(SessionWindowTest, TheCommandLineDrawsTheSamePicture) {
  open_molecule();
  viewer_->state().settings.display.ball_scale = 0.7f;
  viewer_->state().settings.display.ball_paint.by = ColourBy::exposed;
  viewer_->state().settings.display.complex_paint.by = ColourBy::chain;
  viewer_->state().settings.display.shrink = 0.2f;
  run("wait-idle\nalpha.set 2.5\nwait-idle\nmove view 0.4 0.5\ndown\nmove view 0.7 0.6\nup\n"
      "wait-idle\nfile.save_picture " +
      (folder_ / "window.png").string() + " 640 480\nwait-idle\n");
  save();
  const auto screenshot = [this](const std::string& more) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot -q --session " +
                                session().string() + " -o " + (folder_ / "cli.png").string() +
                                " --size 640x480 " + more + " 2> " + (folder_ / "said").string() +
                                " > /dev/null";
    return WEXITSTATUS(std::system(command.c_str()));
  };
  ASSERT_EQ(screenshot(""), 0) << bytes("said");
  const Image window = pixels_of(bytes("window.png")), cli = pixels_of(bytes("cli.png"));
  EXPECT_EQ(cli.width, 640);
  EXPECT_EQ(cli.rgba, window.rgba);
  EXPECT_EQ(screenshot("--alpha 3"), 2);
  EXPECT_NE(bytes("said").find("the session already has the setting of --alpha"),
            std::string::npos);
  fs::rename(molecule(), folder_ / "other.pdb");
  EXPECT_EQ(screenshot(""), 3);
  EXPECT_NE(bytes("said").find(molecule().string()), std::string::npos) << bytes("said");
  EXPECT_EQ(screenshot((folder_ / "other.pdb").string()), 0);
  EXPECT_EQ(pixels_of(bytes("cli.png")).rgba, window.rgba);
}

// --- preferences and recent files

class PreferencesWindowTest : public ViewerTest {
 protected:
  void reset_for_molecule(bool light = false) {
    viewer_.reset();
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    options.light = light;
    options.preferences = folder_ / "config";
    viewer_ = std::make_unique<Viewer>(*host_, options);
    run("wait-idle\n");
  }
};

TEST_F(PreferencesWindowTest, AreKeptFromWindowToWindow) {
  reset_for_molecule();
  run("view.light_theme on\nview.scale 1.5\nengine.set cpu\nopen " + crambin().string() +
      "\nwait-idle\n");
  reset_for_molecule();
  EXPECT_EQ(viewer_->state().window.theme, Theme::light);
  EXPECT_EQ(viewer_->state().window.control_scale, 1.5);
  EXPECT_EQ(viewer_->state().settings.request.engine, EngineChoice::cpu);
  ASSERT_EQ(viewer_->state().recent.size(), 1u);
  EXPECT_EQ(viewer_->state().recent[0], crambin());
  run("file.recent \"" + crambin().string() + "\"\nwait-idle\n");
  EXPECT_EQ(viewer_->state().molecule.name, "1crn.pdb");
  run("file.recent clear\n");
  reset_for_molecule();
  EXPECT_TRUE(viewer_->state().recent.empty());
}

TEST_F(PreferencesWindowTest, AnOptionIsNoPreference) {
  reset_for_molecule(true);
  EXPECT_EQ(viewer_->state().window.theme, Theme::light);
  reset_for_molecule();
  EXPECT_EQ(viewer_->state().window.theme, Theme::dark);
}

TEST_F(PreferencesWindowTest, ADamagedFileIsToldOnceAndTheWindowWorks) {
  fs::create_directories(folder_ / "config");
  std::ofstream(folder_ / "config/preferences.json") << "{";
  reset_for_molecule();
  EXPECT_EQ(viewer_->state().error_title, "Preferences");
  run("click error.ok\nview.light_theme on\nopen " + crambin().string() + "\nwait-idle\n");
  EXPECT_EQ(viewer_->state().error, "");
  EXPECT_TRUE(viewer_->state().molecule.loaded);
  viewer_.reset();
  EXPECT_EQ(bytes("config/preferences.json"), "{");
}

TEST_F(PreferencesWindowTest, WithoutAFolderNothingIsWritten) {
  run("view.light_theme on\nopen " + crambin().string() + "\nwait-idle\n");
  viewer_.reset();
  EXPECT_FALSE(fs::exists(folder_ / "config"));
}

TEST_F(PreferencesWindowTest, TheScaleFollowsAtOnce) {
  run("frames 2\n");
  const WidgetRect before = viewer_->widgets().at("alpha.preset.0");
  run("view.scale 2\nframes 3\n");
  EXPECT_EQ(host_->size().scale, 2);
  EXPECT_EQ(host_->size().width, 1100);
  const WidgetRect after = viewer_->widgets().at("alpha.preset.0");
  EXPECT_NEAR(after.y1 - after.y0, 2 * (before.y1 - before.y0), 2);
  run("view.scale 3\nframes 3\nview.scale auto\nframes 3\n");
  const WidgetRect again = viewer_->widgets().at("alpha.preset.0");
  EXPECT_EQ(again.y1 - again.y0, before.y1 - before.y0);
}

TEST_F(PreferencesWindowTest, PresenterSizeIsLargerAndIsKept) {
  reset_for_molecule();
  run("view.scale 1.25\nframes 3\n");
  const int width = viewer_->state().viewport.width;
  run("view.presenter_size on\nframes 3\n");
  EXPECT_FLOAT_EQ(host_->size().scale, 1.875f);
  EXPECT_EQ(host_->size().width, 1100);
  EXPECT_LT(viewer_->state().viewport.width, width);
  viewer_.reset();
  EXPECT_EQ(read_preferences(folder_ / "config").preferences.width, 880)
      << "of the window as it is without presenter size";
  reset_for_molecule();
  EXPECT_TRUE(viewer_->state().window.presenter_size);
  EXPECT_FLOAT_EQ(host_->size().scale, 1.875f);
  run("view.presenter_size\nframes 3\n");
  EXPECT_FLOAT_EQ(host_->size().scale, 1.25f);
  EXPECT_EQ(viewer_->state().viewport.width, width);
}

}  // namespace
}  // namespace alphascope::testing
