// SPDX-License-Identifier: GPL-3.0-or-later
// Tests labels, distances and angles in the whole window: over the picture, in saved pictures, in
// sessions, and on the command line. They can be undone and removed, and come back with their
// atoms.
#include <algorithm>
#include <map>

#include "core/document/commands/commands.hpp"
#include "core/write/csv.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class AnnotationsTest : public ViewerTest {
 protected:
  void settle() { run("wait-idle\nframes 3\n"); }
  std::vector<std::string> words() {
    std::vector<std::string> texts;
    for (const PictureLabel& label : viewer_->state().viewport.labels) texts.push_back(label.text);
    std::sort(texts.begin(), texts.end());
    return texts;
  }
  const Annotations& annotations() { return viewer_->state().settings.annotations; }
  std::string refusal(const std::string& line) { return viewer_->commands().run_line(line).why; }
  using Words = std::vector<std::string>;
};

TEST_F(AnnotationsTest, LabelsSayNamesAndGoWithTheirAtoms) {
  open_crambin();
  EXPECT_EQ(refusal("label.atoms name"),
            "Nothing of this molecule is selected. Select atoms, or name them.");
  run("select.atoms A:THR 1:CA, A:THR 1:CB\nlabel.atoms name\n");
  settle();
  EXPECT_EQ(words(), (Words{"CA", "CB"}));
  EXPECT_EQ(viewer_->state().undo_text, "labels");
  run("label.atoms residue resi 1-3\n");
  settle();
  EXPECT_EQ(words(), (Words{"CYS 3", "THR 1", "THR 2"})) << "one for each residue";
  run("atoms.hide resi 2\n");
  settle();
  EXPECT_EQ(words(), (Words{"CYS 3", "THR 1"}));
  run("edit.undo\nedit.undo\n");
  settle();
  EXPECT_EQ(words(), (Words{"CA", "CB"}));
  run("label.remove A:THR 1:CA\n");
  settle();
  EXPECT_EQ(words(), Words{"CB"});
  run("key shift+l\n");  // labels the selected atoms
  EXPECT_TRUE(annotations().labels.empty());
  run("key l\n");
  settle();
  EXPECT_EQ(words(), (Words{"A:THR 1:CA", "A:THR 1:CB"}));
  run("label.remove_all\n");
  settle();
  EXPECT_EQ(words(), Words{});
}

// Menu and list show what would be written beside the selected atoms, not an example.
TEST_F(AnnotationsTest, TextsToChooseAreThoseOfTheSelection) {
  open_crambin();
  const auto choices = [&] {
    std::map<std::string, std::string> texts;
    const CommandSpec& label = *viewer_->commands().find("label.atoms");
    for (const Choice& c : label.parameters.front().choices()) texts[c.id] = c.detail;
    return texts;
  };
  EXPECT_EQ(choices()["name"], "such as NE2");
  run("select.atoms A:THR 1:CB\n");
  EXPECT_EQ(choices()["address"], "A:THR 1:CB");
  EXPECT_EQ(choices()["name"], "CB");
  EXPECT_EQ(choices()["element"], "C");
  run("select.atoms A:THR 1:CA, A:THR 1:CB\n");
  EXPECT_EQ(choices()["name"], "CA, …");
}

TEST_F(AnnotationsTest, LabelsAreInThePictureAndFollowTheCamera) {
  open_crambin();
  run("label.atoms address A:THR 1:CA\n");
  settle();
  const PictureLabel before = viewer_->state().viewport.labels.at(0);
  run("view.from z\nframes 3\nwait-idle\n");
  const PictureLabel after = viewer_->state().viewport.labels.at(0);
  EXPECT_GT(std::fabs(after.x - before.x) + std::fabs(after.y - before.y), 5);
  shot("labelled.png");
  run("label.remove_all\nwait-idle\nframes 3\n");
  shot("plain.png");
  EXPECT_GT(differing_pixels(pixels_of(folder_ / "labelled.png"), pixels_of(folder_ / "plain.png")),
            150);
}

TEST_F(AnnotationsTest, TooManyLabelsAreRefused) {
  run("open " + (fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz").string() +
      "\nwait-idle\n");
  EXPECT_EQ(refusal("label.atoms name all"),
            "A picture has at most 1,000 labels. Name fewer atoms, or label their residues.");
  EXPECT_EQ(refusal("label.atoms residue all"), "") << "578 residues";
}

TEST_F(AnnotationsTest, MeasuresInTheOrderOfSelection) {
  open_crambin();
  run("key d\n");
  EXPECT_NE(viewer_->state().notice.text().find("Select two to four atoms"), std::string::npos);
  run("select.atoms A:THR 1:CA\nselect.add A:THR 1:N\nkey d\n");
  settle();
  EXPECT_EQ(words(), Words{"1.498 Å"});
  EXPECT_EQ(viewer_->state().notice.text(), "Distance A:THR 1:CA – A:THR 1:N: 1.498 Å");
  EXPECT_EQ(viewer_->state().undo_text, "measured distances and angles");
  EXPECT_EQ(refusal("measure.atoms"), "This is measured already, as number 1.");
  // N is selected second, so the angle is at N, not at the atom that is second in the file.
  run("select.add A:THR 1:C\nmeasure.atoms\n");
  run("measure.atoms A:THR 1:N; A:THR 1:CA; A:THR 1:C\n");
  settle();
  EXPECT_EQ(words(), (Words{"1.498 Å", "108.2°", "36.0°"}));
  // The angle φ of a residue in crambin's first helix.
  run("measure.remove_all\nmeasure.atoms A:12:C; A:13:N; A:13:CA; A:13:C\n");
  settle();
  EXPECT_EQ(words(), Words{"−59.1°"});
  EXPECT_EQ(refusal("measure.atoms A:12:C; A:13:"),
            "\"A:13:\" names several atoms, such as A:PHE 13:N and A:PHE 13:CA. Name one.");
  EXPECT_EQ(refusal("measure.remove 2"), "There is no number 2; the last is 1.");
}

TEST_F(AnnotationsTest, MeasurementsOutliveOtherOptionsAndAreBackWithTheirAtoms) {
  open_crambin();
  run("measure.atoms A:THR 1:CA; A:THR 2:CA\n");
  settle();
  const Words with = words();
  ASSERT_EQ(with.size(), 1u);
  viewer_->state().settings.open.balls.selection = "not resi 1";
  settle();
  EXPECT_EQ(words(), Words{}) << "one end is not in the picture";
  EXPECT_EQ(annotations().measurements.size(), 1u);
  viewer_->state().settings.open.balls.selection = "";
  run("alpha.set 2\nsolvent.set 1.4\n");
  settle();
  EXPECT_EQ(words(), with);
  open_crambin();
  EXPECT_TRUE(annotations().empty()) << "another file";
}

TEST_F(AnnotationsTest, TheListSelectsRemovesAndCopies) {
  open_crambin();
  run("key shift+d\nframes 2\n");
  EXPECT_TRUE(viewer_->widgets().contains("details.nothing_measured"));
  run("measure.atoms A:THR 1:CA; A:THR 2:CA\nmeasure.atoms A:THR 1:N; A:THR 1:CA; A:THR 1:C\n"
      "frames 3\nclick details.measured.2\nframes 2\n");
  EXPECT_EQ(viewer_->state().settings.selection.items.size(), 3u);
  run("click details.copy\nframes 3\n");
  EXPECT_EQ(viewer_->state().notice.text(), "Copied 2 distances and angles");
  run("click details.remove.1\nframes 3\n");
  ASSERT_EQ(annotations().measurements.size(), 1u);
  EXPECT_EQ(annotations().measurements[0].atoms.size(), 3u);
  EXPECT_FALSE(viewer_->widgets().contains("details.measured.2"));
  run("click details.remove_all\nframes 3\n");
  EXPECT_TRUE(annotations().measurements.empty());
}

TEST_F(AnnotationsTest, SavedPicturesSessionsAndTheCommandLineShowThem) {
  open_crambin();
  DisplaySettings& display = viewer_->state().settings.display;
  const DisplaySettings usual;  // as on the command line
  display.ambient_occlusion = usual.ambient_occlusion;
  display.depth_cue = usual.depth_cue;
  display.outlines = usual.outlines;
  display.samples = 1;
  run("frames 3\nwait-idle\n");
  const auto saved = [&](const std::string& name) {
    viewer_->calls().jobs.save_picture(
        ScreenshotRequest{folder_ / name, {.width = 400, .height = 300}});
    run("wait-idle\n");
    return pixels_of(folder_ / name);
  };
  const Image plain = saved("plain.png");
  run("label.atoms residue resi 10,20,30\nmeasure.atoms A:1:CA; A:20:CA; A:40:CA\nframes 3\n");
  run("wait-idle\n");
  const Image marked = saved("marked.png");
  EXPECT_GT(differing_pixels(plain, marked), 300);
  const std::string session = (folder_ / "labels.json").string();
  run("file.save_session " + session + "\nwait-idle\n");
  const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot --session " + session +
                              " --size 400x300 -o " + (folder_ / "cli.png").string() +
                              " > /dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  EXPECT_LE(share_unlike(marked, pixels_of(folder_ / "cli.png")), 0.001);
  const Annotations before = annotations();
  run("open " + crambin().string() + "\nwait-idle\nopen " + session + "\nwait-idle\n");
  EXPECT_EQ(annotations(), before);
}

TEST_F(AnnotationsTest, MarksAndBordersAreDrawnUndoneAndSaved) {
  run("open " +
      (fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/lessons/unequal_balls.xyzr").string() +
      "\nwait-idle\n");
  run("view.from z\nview.orthographic on\n");
  const Image plain = picture();
  run("mark.point 3 0 0 5 Å²\nmark.line 0 0 0 1.5 2 0 a tangent\nwait-idle\nframes 3\n");
  EXPECT_EQ(words(), (Words{"5 Å²", "a tangent"}));
  EXPECT_EQ(viewer_->state().undo_text, "marks");
  const Image marked = picture();
  EXPECT_GT(differing_pixels(plain, marked), 150);
  run("view.power_diagram on\n");
  EXPECT_GT(differing_pixels(marked, picture()), 150);
  run("edit.undo\nedit.undo\nedit.undo\n");
  EXPECT_EQ(differing_pixels(plain, picture()), 0);
  EXPECT_EQ(refusal("mark.remove_all"), "There is no mark.");
  open_crambin();
  EXPECT_EQ(refusal("view.power_diagram on"),
            "The power diagram is drawn for up to 200 balls; here are 327.");
}

}  // namespace
}  // namespace alphascope::testing
