// SPDX-License-Identifier: GPL-3.0-or-later
// Tests objects in the whole window: the first picture, the list, commands, Undo, sessions, saved
// pictures, the mouse, and sticks in a chosen cavity.
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/layer_objects.hpp"

namespace alphascope::testing {
namespace {

class ObjectsTest : public ViewerTest {
 protected:
  DrawnObjects& objects() { return viewer_->state().settings.objects; }
  std::string list() { return objects_text(objects()); }
  void only_objects() {
    run("view.balls off\nview.tetrahedra off\nview.triangles off\nview.edges off\nwait-idle\n");
  }
  // The pixels that differ from an empty picture.
  int drawn() {
    run("wait-idle\n");
    const DrawnObjects now = objects();
    const Image with = picture();
    objects() = {};
    const Image without = picture();
    objects() = now;
    run("wait-idle\n");
    return differing_pixels(with, without);
  }
};

TEST_F(ObjectsTest, EachKindDrawsAndUndoTakesItBack) {
  open_crambin();
  only_objects();
  EXPECT_EQ(list(), "none");
  for (const ObjectKindInfo& kind : object_kinds()) {
    run("view.objects " + std::string(kind.id) + "\nwait-idle\n");
    EXPECT_EQ(viewer_->state().undo_text, "objects");
    EXPECT_GT(drawn(), 500) << kind.id;
  }
  run("view.objects none\nwait-idle\n");
  const Image nothing = picture();
  run("edit.undo\nwait-idle\n");
  EXPECT_EQ(list(), "points");
  EXPECT_GT(differing_pixels(nothing, picture()), 500);
}

TEST_F(ObjectsTest, AtomsColoursAndHidingAreFollowed) {
  open_crambin();
  only_objects();
  run("view.objects sticks\nwait-idle\n");
  Image last = picture();
  for (const char* change : {"view.objects sticks:resi 1-20", "view.objects sticks,chain:resi 1-20",
                             "atoms.hide resi 1-10", "view.objects sticks,chain,40%:resi 1-20"}) {
    run(std::string(change) + "\nwait-idle\n");
    const Image now = picture();
    EXPECT_GT(differing_pixels(last, now), 100) << change;
    last = now;
  }
}

TEST_F(ObjectsTest, CommandsSwitchAndRefuse) {
  open_crambin();
  run("view.cartoon\n");
  EXPECT_EQ(list(), "cartoon");
  run("view.cartoon off\n");
  EXPECT_EQ(list(), "cartoon,hidden");
  run("view.cartoon on\nview.sticks on\n");
  EXPECT_EQ(list(), "cartoon; sticks:ligand");
  EXPECT_NE(viewer_->commands().run_line("view.objects ribbons").why, "");
  EXPECT_EQ(list(), "cartoon; sticks:ligand");
}

TEST_F(ObjectsTest, TheListHidesRemovesAndAdds) {
  open_crambin();
  run("view.section objects\nview.objects cartoon; points\nwait-idle\n");
  run("move objects.1\ndown\nup\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,hidden; points");
  run("move objects.2.remove\ndown\nup\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,hidden");
  run("move objects.balls\ndown\nup\nwait-idle\n");
  EXPECT_FALSE(viewer_->state().settings.display.balls);
  run("move objects.add\ndown\nup\nwait-idle\nmove objects.add.5\ndown\nup\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,hidden; sticks");
  // The new object's settings are open: its atoms are typed.
  run("move objects.2.atoms\ndown\nup\ntype resi 1-3\nkey enter\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,hidden; sticks:resi 1-3");
  run("move objects.2.atoms\ndown\nup\ntype (((\nkey enter\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,hidden; sticks:resi 1-3");  // a fault changes nothing
}

TEST_F(ObjectsTest, SessionsAndSavedPicturesHaveThem) {
  open_crambin();
  only_objects();
  run("view.objects cartoon,secondary; sticks,50%:sidechain\nwait-idle\n");
  const std::string session = (folder_ / "objects.json").string();
  const std::string saved = (folder_ / "saved.png").string();
  const std::string drawn = (folder_ / "drawn.png").string();
  run("file.save_session " + session + "\nwait-idle\nfile.save_picture " + saved +
      " 640 480\nwait-idle\n");
  run("open " + crambin().string() + "\nwait-idle\n");
  EXPECT_EQ(list(), "none");
  run("open " + session + "\nwait-idle\n");
  EXPECT_EQ(list(), "cartoon,secondary; sticks,50%:sidechain");
  const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot --session " + session +
                              " --size 640x480 -o " + drawn + " > /dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_LT(compare_pictures(pixels_of(fs::path(saved)), pixels_of(fs::path(drawn))).share, 0.02);
}

TEST_F(ObjectsTest, TheMouseFindsResiduesOfACartoon) {
  open_crambin();
  only_objects();
  run("view.objects cartoon\nwait-idle\n");
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    run("move view 0." + std::to_string(30 + k) + " 0.5\nwait-idle\n");
    if (!viewer_->state().hovered) continue;
    ++found;
    const std::string& line = viewer_->state().viewport.under_mouse_line;
    EXPECT_NE(line.find(":CA "), std::string::npos) << line;
  }
  EXPECT_GT(found, 5);
  run("view.objects none\nwait-idle\nmove view 0.5 0.5\nwait-idle\n");
  EXPECT_FALSE(viewer_->state().hovered);
}

TEST_F(ObjectsTest, AChosenCavityHasItsLigandAndItsLiningAsSticks) {
  run("open " ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz\nwait-idle\n");
  run("view.page cavities\nsolvent.set 1.4\nwait-idle\ncavities.choose 1\nwait-idle\n");
  const auto sticks = [&] {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == "cavities.lining") return layer->objects->of.front();
    }
    return LayerObject();
  };
  EXPECT_GT(sticks().atoms.size(), 700u);  // 131 residues line it
  EXPECT_LT(sticks().atoms.size(), 1500u);
  const Image with = picture();
  run("view.lining_opacity 0.3\nwait-idle\n");
  EXPECT_FLOAT_EQ(sticks().object.opacity, 0.3F);
  run("view.lining_sticks off\nwait-idle\n");
  EXPECT_TRUE(sticks().atoms.empty());
  EXPECT_GT(differing_pixels(with, picture()), 300);
}

}  // namespace
}  // namespace alphascope::testing
