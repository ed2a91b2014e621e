// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page of areas and volumes in the whole window, and balls coloured by exposed area.
#include <imgui.h>

#include <algorithm>

#include "core/document/measures/measure_results.hpp"
#include "core/document/measures/measure_rows.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/measures/measure_state.hpp"

namespace alphascope::testing {
namespace {

class MeasuresTest : public ViewerTest {
 protected:
  void open_measures() {
    open_crambin();
    run("click bottom.measures\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  }
  void settle() { run("wait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  MeasureState& memory() { return memory_of<MeasureState>(viewer_->panels(), "measures"); }
  ViewState& state() { return viewer_->state(); }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  UnionMeasures expected_measures(double alpha, double solvent) {
    const BallSet balls = with_solvent(*viewer_->session().state().prepared->balls, solvent);
    return measure_union(balls, expected(alpha, solvent));
  }
};

TEST_F(MeasuresTest, ThePageHasTheNumbersOfThePicture) {
  open_measures();
  ASSERT_TRUE(memory().measured && memory().rows);
  EXPECT_EQ(memory().measured->measures().area_angstrom2(),
            expected_measures(0, 0).area_angstrom2());
  EXPECT_EQ(memory().surface, "van der Waals surface");
  EXPECT_EQ(memory().rows->rows.size(), 46u) << "residues of crambin";
  EXPECT_TRUE(has("measures.row.1"));
  EXPECT_TRUE(has("measures.area") && has("measures.volume") && has("measures.arcs"));
  const WidgetRect surface = viewer_->widgets().at("measures.surface");
  EXPECT_LT(viewer_->widgets().at("measures.components").x1, surface.x0) << "nothing is cut off";
  EXPECT_GT(surface.x1 - surface.x0, 100) << "its whole text";
  EXPECT_GT(memory().measured->measures().total[MeasuredQuantity::arc_length], 100) << "Å";
  state().settings.request.solvent_radius_angstrom = 1.4;
  settle();
  const UnionMeasures accessible = expected_measures(0, 1.4);
  EXPECT_EQ(memory().measured->measures().area_angstrom2(), accessible.area_angstrom2());
  EXPECT_EQ(memory().measured->measures().volume_angstrom3(), accessible.volume_angstrom3());
  EXPECT_EQ(memory().measured->measures().total[MeasuredQuantity::arc_length],
            accessible.total[MeasuredQuantity::arc_length]);
  EXPECT_EQ(memory().surface, "solvent-accessible surface, probe of 1.4 Å");
}

TEST_F(MeasuresTest, AClickSelectsTheAtomsOfTheRow) {
  open_measures();
  run("click measures.row.2 0.3\nwait-idle\nframes 3\n");
  EXPECT_EQ(memory().chosen.size(), 1u);
  EXPECT_EQ(state().settings.selection.items.size(), memory().rows->rows[1].atoms);
  // A row stays chosen while alpha moves. With other rows it is forgotten.
  run("alpha.set 0.5\n");
  settle();
  EXPECT_EQ(memory().chosen.size(), 1u);
  EXPECT_EQ(state().result->request.alpha_angstrom2, 0.5);
  run("click measures.per.3\n");
  settle();
  EXPECT_EQ(memory().per, 3);
  EXPECT_TRUE(memory().chosen.empty());
  EXPECT_EQ(memory().rows->rows.size(), state().result->balls->size());
}

TEST_F(MeasuresTest, ChangesAndFilter) {
  open_measures();
  run("click measures.per.3\nclick measures.changes 0.1\n");
  settle();
  ASSERT_TRUE(memory().rows->derivatives);
  EXPECT_TRUE(has("measures.column.volume_by_radius_angstrom2"));
  memory().query.filter = ":ca";
  settle();
  EXPECT_EQ(memory().rows->rows.size(), 46u);
  EXPECT_EQ(memory().rows->all, 327u);
}

TEST_F(MeasuresTest, TitlesSortAndRowsAreCopied) {
  open_measures();
  run("click measures.column.area_angstrom2\n");
  settle();
  const std::vector<MeasureRow>& rows = memory().rows->rows;
  EXPECT_EQ(memory().query.column, "area_angstrom2");
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(),
                             [](const MeasureRow& a, const MeasureRow& b) {
                               return a.of[MeasuredQuantity::area] > b.of[MeasuredQuantity::area];
                             }))
      << "the largest first";
  run("click measures.copy\n");
  settle();
  EXPECT_EQ(state().notice.text(), "Areas and volumes copied as CSV.");
  EXPECT_FALSE(memory().copying);
  const std::string copied = ImGui::GetClipboardText();
  run("click measures.save\nframes 3\n");
  state().save_table.path = (folder_ / "m.csv").string();
  run("click save_table.ok\n");
  settle();
  EXPECT_EQ(state().notice.text(), "Saved " + (folder_ / "m.csv").string());
  EXPECT_EQ(bytes("m.csv"), copied);
}

TEST_F(MeasuresTest, TetrahedraAloneSayWhatToDo) {
  open_measures();
  state().settings.request.tetrahedra_only = true;
  settle();
  EXPECT_TRUE(has("measures.waiting"));
  EXPECT_FALSE(has("measures.area"));
  state().settings.display.ball_paint.by = ColourBy::exposed;
  settle();
  EXPECT_NE(state().viewport.not_drawn.find("Tetrahedra only"), std::string::npos);
  EXPECT_EQ(state().viewport.legends.size(), 1u) << "of the simplices";
}

TEST_F(MeasuresTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.measures\n");
  EXPECT_TRUE(has("measures.waiting"));
}

TEST_F(MeasuresTest, BallsAreColouredByTheirExposedAreas) {
  open_crambin();
  state().settings.display.tetrahedra = false;
  const Image by_element = picture();
  state().settings.display.ball_paint.by = ColourBy::exposed;
  settle();
  EXPECT_EQ(state().viewport.not_drawn, "");
  ASSERT_EQ(state().viewport.legends.size(), 1u);
  EXPECT_EQ(state().viewport.legends[0].title, "exposed area of atoms (%), square-root scale");
  EXPECT_EQ(state().viewport.legends[0].stops.front().value, 0);
  EXPECT_EQ(state().viewport.legends[0].stops.back().value, 100);
  const Image by_atom = picture();
  EXPECT_NE(by_atom.rgba, by_element.rgba);
  state().settings.display.ball_paint.by = ColourBy::exposed_residue;
  settle();
  EXPECT_EQ(state().viewport.legends[0].title, "exposed area of residues (%), square-root scale");
  EXPECT_NE(picture().rgba, by_atom.rgba);
  state().settings.display.ball_paint.by = ColourBy::element;
  settle();
  EXPECT_EQ(state().viewport.legends[0].title, "element");
  EXPECT_EQ(picture().rgba, by_element.rgba);
}

}  // namespace
}  // namespace alphascope::testing
