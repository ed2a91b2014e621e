// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the signature panel in the whole window: curves, a click that sets alpha, marks in the
// picture.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/well_formed_xml.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class SignatureTest : public ViewerTest {
 protected:
  void open_signature() {
    open_crambin();
    run("click bottom.signature\nwait-idle\nframes 3\nwait-idle\n");
  }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
};

TEST_F(SignatureTest, AClickSetsAlphaAndIsOneEntry) {
  open_signature();
  ASSERT_TRUE(has("signature.plot"));
  ASSERT_TRUE(has("signature.values"));
  run("move signature.plot 0.5\ndown\nmove signature.plot 0.6\nmove signature.plot 0.8\nup\n");
  run("wait-idle\n");
  const double alpha = viewer_->state().settings.request.alpha_angstrom2;
  EXPECT_GT(alpha, 5);
  EXPECT_LT(alpha, 9);
  EXPECT_EQ(viewer_->state().result->request.alpha_angstrom2, alpha);
  run("edit.undo\nwait-idle\n");
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0);
  EXPECT_EQ(viewer_->state().undo_text, "");
}

// The last row of the table has all simplices that there are at the right end.
TEST_F(SignatureTest, IsSavedAsATableAndAsAFigure) {
  open_signature();
  const auto saved = [&](const char* name) {
    run("click signature.save\nframes 3\n");
    viewer_->state().save_table.path = (folder_ / name).string();
    run("click save_table.ok\nwait-idle\nframes 3\nwait-idle\n");
    std::ifstream file(folder_ / name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  };
  const std::string csv = saved("signature.csv");
  EXPECT_NE(csv.find("\nalpha (Å²),vertices,edges,triangles,tetrahedra,Euler characteristic\n"),
            std::string::npos)
      << csv.substr(0, 800);
  EXPECT_NE(csv.find("# sha256: "), std::string::npos);
  run("alpha.set 10\nwait-idle\n");
  const AlphaComplex& complex = viewer_->state().result->complex;
  std::string last = "\n10";
  for (const std::size_t n : {complex.vertices.size(), complex.edges.size(),
                              complex.triangles.size(), complex.tetrahedra.size()}) {
    last += "," + std::to_string(n);
  }
  EXPECT_NE(csv.find(last + ","), std::string::npos) << last << "\n"
                                                     << csv.substr(csv.size() - 200);
  const std::string svg = saved("signature.svg");
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_NE(svg.find("Euler characteristic"), std::string::npos);
}

TEST_F(SignatureTest, MarksWhatAppearsInThePicture) {
  open_signature();
  run("click alpha.preset.3\nwait-idle\n");
  EXPECT_TRUE(viewer_->state().layers.empty()) << "off until it is asked for";
  run("click signature.mark 0.05\nwait-idle\nframes 3\nwait-idle\n");
  ASSERT_EQ(viewer_->state().layers.size(), 1u);
  const Layer& layer = *viewer_->state().layers.front();
  const Filtration whole(layer.balls, make_triangulation(*layer.balls, 1));
  std::size_t expected = 0;
  for (const float value : whole.top().tetrahedra.alpha_values) {
    const double alpha = layer.balls->lattice.square_angstrom(value);
    expected += std::abs(alpha - 3) <= 0.02;
  }
  EXPECT_EQ(layer.tetrahedra.size(), expected);
  EXPECT_GT(expected, 0u);
  const Image marked = picture();
  run("click signature.mark 0.05\n");
  EXPECT_TRUE(viewer_->state().layers.empty());
  EXPECT_NE(picture().rgba, marked.rgba);
}

TEST_F(SignatureTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.signature\n");
  EXPECT_TRUE(has("signature.waiting"));
  EXPECT_FALSE(has("signature.plot"));
}

TEST_F(SignatureTest, TheTimingsAreOnePageAway) {
  open_signature();
  EXPECT_FALSE(has("timings.run.0"));
  run("click bottom.timings\n");
  EXPECT_TRUE(has("timings.run.0"));
}

}  // namespace
}  // namespace alphascope::testing
