// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page Structure: clicks select residues, ranges and cavities, and the mouse is followed
// both ways.
#include "core/document/reference/reference.hpp"
#include "core/document/structure/structure_rows.hpp"
#include "core/secondary/secondary_once.hpp"
#include "tests/ui/viewer_fixture.hpp"

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
