// The panel of cavities in the whole window: the table, CASTp's choices, a cavity in the picture.
#include <map>

#include "core/document/cavity_results.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class CavitiesTest : public ViewerTest {
 protected:
  void open_cavities() {
    run("open " ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz\nwait-idle\n");
    run("click bottom.cavities\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  }
  void use_preset() { run("click cavities.preset\nwait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  const CavityMemory& memory() { return viewer_->state().memory.cavities; }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
};

TEST_F(CavitiesTest, ThePresetComparesWithCastpAndCanBeUndone) {
  open_cavities();
  ASSERT_TRUE(has("cavities.row.1"));
  ASSERT_TRUE(has("cavities.preset")) << "radii, ligands and solvent radius are others";
  const std::size_t before = memory().lines.size();
  use_preset();
  EXPECT_FALSE(has("cavities.preset"));
  EXPECT_EQ(viewer_->state().result->request.solvent_radius_angstrom, 1.4);
  EXPECT_EQ(viewer_->state().references->prepared().report.radii, RadiiSet::castp);
  EXPECT_EQ(memory().table->voids, 47u);
  EXPECT_EQ(memory().table->pockets, 39u);
  EXPECT_NE(memory().lines.size(), before);
  // A line for each cavity, with the exact volume once it is there.
  ASSERT_EQ(memory().lines.size(), 86u);
  EXPECT_NEAR(memory().lines[0].volume, 3989.080, 0.001);
  EXPECT_GT(memory().lines[0].exact_volume, 3990);
  EXPECT_EQ(memory().lines[3].name, "A:PHE 43:CZ A:HIS 87:NE2 A:VAL 93:CG2 A:LEU 101:CD2");
  run("edit.undo\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_TRUE(has("cavities.preset"));
  EXPECT_EQ(memory().lines.size(), before);
}

TEST_F(CavitiesTest, AClickShowsTheCavityAndWhatLinesIt) {
  open_cavities();
  use_preset();
  const Image plain = picture();
  run("click cavities.row.4 0.2\nwait-idle\nframes 5\n");
  ASSERT_EQ(viewer_->state().layers.size(), 2u) << "its surface, and the rims of its mouths";
  const Layer& body = *viewer_->state().layers[0];
  EXPECT_TRUE(body.body);
  // The boundary of tetrahedra is closed: each edge has an even number of triangles.
  std::map<std::pair<BallIndex, BallIndex>, int> edges;
  for (const auto& t : body.triangles) {
    ++edges[{t[0], t[1]}];
    ++edges[{t[0], t[2]}];
    ++edges[{t[1], t[2]}];
  }
  EXPECT_FALSE(edges.empty());
  for (const auto& [edge, count] : edges) EXPECT_EQ(count % 2, 0);
  EXPECT_FALSE(viewer_->state().layers[1]->edges.empty());
  EXPECT_NE(picture().rgba, plain.rgba);
  EXPECT_NE(memory().lining.find("A:HIS 87"), std::string::npos) << memory().lining;
  EXPECT_GT(viewer_->state().picked.items.size(), 20u);
  // It stays chosen while alpha moves, for it is known by its deepest sink.
  const SimplexRef sink = memory().lines[3].sink;
  run("alpha.set 0.1\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  ASSERT_EQ(memory().table->question.alpha_angstrom2, 0.1);
  EXPECT_EQ(memory().chosen, std::vector<SimplexRef>{sink});
  EXPECT_EQ(viewer_->state().layers.size(), 2u);
}

TEST_F(CavitiesTest, OfAnotherMoleculeNothingStays) {
  open_cavities();
  run("click cavities.row.1 0.2\nwait-idle\nframes 3\n");
  EXPECT_EQ(memory().chosen.size(), 1u);
  open_crambin();
  run("wait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_TRUE(memory().chosen.empty());
  EXPECT_TRUE(viewer_->state().layers.empty());
}

TEST_F(CavitiesTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.cavities\n");
  EXPECT_TRUE(has("cavities.waiting"));
  EXPECT_FALSE(has("cavities.totals"));
}

}  // namespace
}  // namespace alphascope::testing
