// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page Details in the whole window: facts of the selected atom or simplex, and lists that
// lead to its neighbours.
#include <algorithm>

#include "core/document/explain/simplex_details.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/explain/details_state.hpp"

namespace alphascope::testing {
namespace {

class DetailsTest : public ViewerTest {
 protected:
  bool has(const std::string& widget) { return viewer_->widgets().contains(widget); }
  const std::shared_ptr<const SimplexDetails>& shown() {
    return memory_of<DetailsState>(viewer_->panels(), "details").shown;
  }
  void show(const std::string& atoms) {
    run("select.atoms " + atoms + "\ndetails.show\nframes 3\nwait-idle\nframes 3\n");
  }
};

TEST_F(DetailsTest, AnAtomHasFactsAndNeighbours) {
  open_crambin();
  run("alpha.set 1.4\ndetails.show\nwait-idle\n");
  EXPECT_TRUE(has("details.nothing"));
  show("A:THR 1:CA");
  for (const char* name : {"element", "centre", "size", "B factor", "class", "is part of"}) {
    EXPECT_TRUE(has(std::string("details.fact.") + name)) << name;
  }
  const SimplexDetails* details = shown().get();
  ASSERT_NE(details, nullptr);
  const AlphaComplex expected = this->expected(1.4);
  const BallIndex ball = details->balls.at(0);
  const auto& edges = expected.edges.simplices;
  const auto joined = std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return edge[0] == ball || edge[1] == ball;
  });
  ASSERT_GT(joined, 2);
  EXPECT_EQ(static_cast<long>(details->neighbours.size()), joined);
  const BallIndex nearest = details->neighbours[0].ball;
  run("click details.neighbour.0\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().settings.selection.items,
            RefSet({viewer_->state().references->atom(nearest)}));
  EXPECT_EQ(shown()->balls, std::vector<BallIndex>{nearest});
  // The same at another alpha.
  run("alpha.set -100\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_FALSE(shown()->in_complex);
  EXPECT_FALSE(has("details.neighbour.0"));
}

TEST_F(DetailsTest, ASimplexHasVerticesAndNeighbours) {
  open_crambin();
  run("alpha.set 3\nwait-idle\n");
  const AlphaComplex expected = this->expected(3);
  const auto& tetrahedron = expected.tetrahedra.simplices.at(expected.tetrahedra.size() / 2);
  viewer_->state().settings.selection.items =
      RefSet({viewer_->state().references->reference(tetrahedron)});
  run("details.show\nframes 3\nwait-idle\nframes 3\n");
  for (const char* name : {"details.corner.0", "details.corner.3", "details.fact.alpha value"}) {
    EXPECT_TRUE(has(name)) << name;
  }
  const SimplexDetails details = *shown();
  ASSERT_FALSE(details.beside.empty());
  run("click details.beside.0.zoom\nframes 3\nwait-idle\n");
  run("click details.beside.0\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_EQ(shown()->balls, details.beside[0]);
  run("click details.corner.1\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_EQ(shown()->balls, std::vector<BallIndex>{details.beside[0][1]});
}

}  // namespace
}  // namespace alphascope::testing
