// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page Structure: clicks select residues, ranges and cavities, and the mouse is followed
// both ways.
#include <array>

#include "core/document/reference/reference.hpp"
#include "core/document/structure/structure_rows.hpp"
#include "core/secondary/secondary_once.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/frame/context_state.hpp"

namespace alphascope::testing {
namespace {

class StructureTest : public ViewerTest {
 protected:
  StructureTest() : ViewerTest(false) {}
  void open_page(const fs::path& file) {
    run("open " + file.string() + "\nview.page structure\nwait-idle\n");
  }
  std::size_t selected() { return viewer_->state().settings.selection.items.size(); }
  void click(const std::string& widget) { run("move " + widget + "\ndown\nup\nwait-idle\n"); }
  void ctrl_click(const char* widget, float x, float y) {
    const WidgetRect at = viewer_->widgets().at(widget);
    ScriptedInput input;
    input.control = true;
    input.x = at.x0 + x * (at.x1 - at.x0);
    input.y = at.y0 + y * (at.y1 - at.y0);
    for (const bool down : {false, true, false}) {
      input.down[0] = down;
      for (int n = 0; n < 2; ++n) viewer_->step(&input);
    }
    run("wait-idle\n");
  }
};

const fs::path kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";

TEST_F(StructureTest, ALetterIsAResidue) {
  open_page(crambin());
  click("structure.sequence.1 0.01 0.5");
  EXPECT_EQ(selected(), 7u);  // the atoms of THR 1
  const auto& items = viewer_->state().settings.selection.items.items();
  EXPECT_EQ(std::get<AtomRef>(items.front()).atom, 0u);
  EXPECT_EQ(viewer_->state().undo_text, "selection");
}

// Ctrl+click completes a residue before it removes it.
TEST_F(StructureTest, CtrlClickSelectsAResidueWhollyFirst) {
  open_page(crambin());
  run("select.atoms A:THR 1:CA\nframes 2\n");
  ASSERT_EQ(selected(), 1u);
  ctrl_click("structure.sequence.1", 0.01F, 0.5F);
  EXPECT_EQ(selected(), 7u);
  ctrl_click("structure.sequence.1", 0.01F, 0.5F);
  EXPECT_EQ(selected(), 0u);
  run("select.atoms A:THR 1:CA\nframes 2\n");
  ctrl_click("structure.branch.1", 0.5F, 0.5F);
  EXPECT_EQ(selected(), 327u);
  ctrl_click("structure.branch.1", 0.5F, 0.5F);
  EXPECT_EQ(selected(), 0u);
}

// Commands select balls only. Of a residue with alternative locations, that is all of it.
TEST_F(StructureTest, CtrlClickRemovesAResidueWithoutItsLeftOutAtoms) {
  const fs::path file = folder_ / "glycine.pdb";
  std::ofstream(file)
      << "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N\n"
         "ATOM      2  CA AGLY A   1       1.458   0.000   0.000  0.60  0.00           C\n"
         "ATOM      3  CA BGLY A   1       1.458   0.100   0.000  0.40  0.00           C\n"
         "ATOM      4  C   GLY A   1       2.009   1.420   0.000  1.00  0.00           C\n"
         "ATOM      5  O   GLY A   1       1.251   2.390   0.000  1.00  0.00           O\n"
         "END\n";
  open_page(file);
  run("select.atoms A:\nframes 2\n");
  ASSERT_EQ(selected(), 4u) << "one location is left out";
  ctrl_click("structure.sequence.1", 0.5F, 0.5F);
  EXPECT_EQ(selected(), 0u);
}

// A letter is marked as soon as any atom of its residue is selected.
TEST_F(StructureTest, TheStripMarksAPartlySelectedResidue) {
  open_page(crambin());
  const auto first_letter = [&] {  // a pixel in the corner of its cell
    shot("strip.png");
    const WidgetRect at = viewer_->widgets().at("structure.sequence.1");
    const Image image = pixels_of(folder_ / "strip.png");
    const std::size_t x = std::size_t(at.x0) + 1, y = std::size_t(at.y0) + 1;
    const std::uint8_t* const pixel = &image.rgba[4 * (y * std::size_t(image.width) + x)];
    return std::array{pixel[0], pixel[1], pixel[2]};
  };
  const auto before = first_letter();
  run("select.atoms A:THR 1:CA\nframes 2\n");
  ASSERT_EQ(selected(), 1u);
  const auto partly = first_letter();
  EXPECT_NE(partly, before);
  run("select.atoms A:THR 1\nframes 2\n");
  EXPECT_EQ(selected(), 7u);
  EXPECT_EQ(first_letter(), partly) << "the mark is that of a whole residue";
  run("select.none\nframes 2\n");
  EXPECT_EQ(first_letter(), before);
}

TEST_F(StructureTest, SecondaryStructureIsThatOfTheCartoon) {
  run("view.page timings\nopen " + crambin().string() + "\nwait-idle\n");
  const auto references = viewer_->state().references;
  EXPECT_FALSE(references->secondary().known());
  run("view.cartoon on\nwait-idle\n");
  EXPECT_EQ(viewer_->state().references, references);
  EXPECT_TRUE(references->secondary().known());
}

TEST_F(StructureTest, BranchesOpenAndSelect) {
  open_page(kHaemoglobin);
  click("structure.branch.5 0.5 0.5");  // ligands: four haems of 43 atoms, two phosphorus atoms
  EXPECT_EQ(selected(), 174u);
  click("structure.branch.5 0.02 0.5");  // the arrow opens, and selects nothing else
  EXPECT_EQ(selected(), 174u);
  click("structure.residue.575");
  EXPECT_EQ(selected(), 43u);
}

TEST_F(StructureTest, TheMouseIsFollowedBothWays) {
  open_page(crambin());
  const auto marked = [&] {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == "structure.hovered") return layer->vertices.size();
    }
    return std::size_t{0};
  };
  run("move structure.sequence.1 0.01 0.5\nwait-idle\n");
  EXPECT_EQ(marked(), 7u);
  run("move status.memory\nwait-idle\n");
  EXPECT_EQ(marked(), 0u);
}

// Rows of the molecule before must not be drawn with the atoms of the new one.
TEST_F(StructureTest, AnotherMoleculeComesWhileABranchIsOpen) {
  open_page(kHaemoglobin);
  click("structure.branch.1 0.02 0.5");
  ASSERT_TRUE(viewer_->widgets().contains("structure.residue.1"));
  run("open " + crambin().string() + "\n");
  while (viewer_->busy() || viewer_->state().molecule.name != "1crn.pdb") viewer_->step(nullptr);
  run("frames 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("structure.branch.1"));
  EXPECT_FALSE(viewer_->widgets().contains("structure.branch.2"));
}

TEST_F(StructureTest, TheMenuOfAResidueIsAboutAllItsAtoms) {
  open_page(crambin());
  const auto& hidden = viewer_->state().settings.appearance.hidden;
  run("right-click structure.sequence.1 0.01 0.5\nframes 2\n");
  EXPECT_EQ(viewer_->state().context.title, "THR 1");
  run("click context.hide\nframes 2\nwait-idle\n");
  EXPECT_EQ(hidden.size(), 7u);
  EXPECT_EQ(selected(), 0u);
  run("right-click structure.branch.1 0.5 0.5\nframes 2\n");
  EXPECT_EQ(viewer_->state().context.title, "Chain A");
  run("click context.select\nframes 2\nwait-idle\n");
  EXPECT_EQ(selected(), 327u);
}

TEST_F(StructureTest, AChosenCavityStays) {
  run("open " + kHaemoglobin.string() + "\nview.page cavities\nsolvent.set 1.4\nwait-idle\n" +
      "cavities.choose 1\nwait-idle\nframes 3\nwait-idle\n");
  const auto drawn = [&] {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == "cavities.body.0") return true;
    }
    return false;
  };
  ASSERT_TRUE(drawn());
  run("view.page structure\nwait-idle\nframes 3\n");
  EXPECT_TRUE(drawn()) << "its branch is closed";
  click("structure.sequence.1 0.01 0.5");
  EXPECT_EQ(selected(), 7u);
  EXPECT_TRUE(drawn());
}

// Escape closes a menu, and does nothing else then.
TEST_F(StructureTest, EscapeClosesAMenuAlone) {
  open_page(crambin());
  click("structure.sequence.1 0.01 0.5");
  run("right-click structure.sequence.1 0.3 0.5\nframes 2\n");
  ASSERT_TRUE(viewer_->widgets().contains("context.title"));
  run("key esc\nframes 2\n");
  EXPECT_FALSE(viewer_->widgets().contains("context.title"));
  EXPECT_EQ(selected(), 7u);
  run("key esc\nframes 2\n");
  EXPECT_EQ(selected(), 0u);
}

TEST_F(StructureTest, CavitiesAreChosen) {
  open_page(kHaemoglobin);
  run("solvent.set 1.4\nwait-idle\n");
  click("structure.cavities");
  click("structure.cavity.1");
  EXPECT_EQ(viewer_->state().cavities.chosen.size(), 1u);
  EXPECT_GT(selected(), 100u);  // its lining
}

}  // namespace
}  // namespace alphascope::testing
