// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page Structure: clicks select residues, ranges and cavities, and the mouse is followed
// both ways.
#include "core/document/reference/reference.hpp"
#include "core/document/structure/structure_rows.hpp"
#include "core/secondary/secondary_once.hpp"
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
