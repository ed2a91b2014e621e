// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page of curves in the whole window: totals, a chosen cavity, and clicks that set the
// quantity of the horizontal axis.
#include <imgui.h>
#include <optional>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_curves.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/support/well_formed_xml.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/measures/curve_state.hpp"

namespace alphascope::testing {
namespace {

class CurvesTest : public ViewerTest {
 protected:
  void open_haemoglobin() {
    run("open " ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz\nwait-idle\n");
    run("click bottom.cavities\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
    run("solvent.set 1.4\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  }
  void open_curves() { run("click bottom.curves\nwait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  void settle() { run("wait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  const CurveState& memory() { return memory_of<CurveState>(viewer_->panels(), "curves"); }
  // Opens the page, and ends the computation of its curves.
  void open_curves_cancelled() {
    run("click bottom.curves\nframes 2\nclick curves.cancel\n");
    settle();
    ASSERT_TRUE(has("curves.again"));
  }
  // Drags the slider of the solvent radius over these radii (Å), and waits for a table of each.
  // `at_each` is called while the button is down.
  template <class AtEach>
  void drag_solvent(const std::vector<double>& radii, const AtEach& at_each) {
    const WidgetRect slider = viewer_->widgets().at("alpha.solvent");
    ScriptedInput input;
    input.y = (slider.y0 + slider.y1) / 2;
    for (const double radius : radii) {
      input.x = slider.x0 + static_cast<float>(radius / 5) * (slider.x1 - slider.x0);
      viewer_->step(&input);
      input.down[0] = true;
      const auto begin = std::chrono::steady_clock::now();
      do {
        ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
        viewer_->step(&input);
      } while (page().rows.table().question.solvent_radius_angstrom != radius_set());
      viewer_->step(&input);
      at_each();
    }
    input.down[0] = false;
    viewer_->step(&input);
  }
  const CavityPage& page() { return *viewer_->state().cavities.page; }
  double radius_set() { return viewer_->state().settings.request.solvent_radius_angstrom; }
  // The plotted value at a radius; none if there is none.
  std::optional<double> value_at(std::size_t n, double radius) {
    const auto& x = series(n).x;
    const auto at = std::find(x.begin(), x.end(), radius);
    return at == x.end() ? std::nullopt
                         : series(n).values[static_cast<std::size_t>(at - x.begin())];
  }
  const ChartSeries& series(std::size_t n) { return memory().chart.chart.series.at(n); }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
};

TEST_F(CurvesTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.curves\n");
  EXPECT_TRUE(has("curves.waiting"));
  EXPECT_FALSE(has("curves.plot"));
}

TEST_F(CurvesTest, OfNothingChosenItPlotsTheTotals) {
  open_haemoglobin();
  open_curves();
  ASSERT_TRUE(has("curves.plot"));
  ASSERT_EQ(memory().chart.chart.series.size(), 2u);
  ASSERT_EQ(series(0).x.size(), 51u);
  EXPECT_EQ(series(0).x[14], 1.4);
  EXPECT_GT(*series(0).values[14], 1) << "voids";
  EXPECT_GT(*series(1).values[14], 1000) << "pockets";
  run("click curves.axis.0\n");
  settle();
  ASSERT_TRUE(has("curves.plot"));
  EXPECT_EQ(memory().chart_axis, CurveAxis::alpha);
  const auto zero = std::find(series(0).x.begin(), series(0).x.end(), 0.0);
  ASSERT_NE(zero, series(0).x.end());
  run("click curves.axis.2\n");
  settle();
  EXPECT_TRUE(has("curves.waiting")) << "one model only";
  EXPECT_FALSE(has("curves.plot"));
}

TEST_F(CurvesTest, AChosenCavityIsFollowedAndAClickSetsTheSolventRadiusAsOneEntry) {
  open_haemoglobin();
  run("click cavities.row.4 0.2\n");
  settle();
  open_curves();
  ASSERT_TRUE(has("curves.plot"));
  ASSERT_EQ(memory().chart.chart.series.size(), 1u);
  EXPECT_EQ(series(0).name, "pocket 4");
  ASSERT_TRUE(series(0).values[14]);
  const double volume = *series(0).values[14];
  EXPECT_GT(volume, 10);
  EXPECT_FALSE(series(0).values[50]) << "no cavity at 5 Å";
  EXPECT_FALSE(memory().chart.marks.empty());
  const std::string undo = viewer_->state().undo_text;
  run("move curves.plot 0.3\ndown\nmove curves.plot 0.4\nmove curves.plot 0.5\nup\n");
  settle();
  const double radius = viewer_->state().settings.request.solvent_radius_angstrom;
  EXPECT_NE(radius, 1.4);
  EXPECT_EQ(viewer_->state().result->request.solvent_radius_angstrom, radius);
  ASSERT_TRUE(has("curves.plot"));
  ASSERT_EQ(memory().chart.chart.series.size(), 1u) << "it is still that cavity";
  EXPECT_EQ(*series(0).values[14], volume);
  run("edit.undo\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.request.solvent_radius_angstrom, 1.4);
  EXPECT_EQ(viewer_->state().undo_text, undo);
  run("click curves.quantity.1\n");
  settle();
  EXPECT_EQ(memory().chart.chart.value_label, "SA area (Å²)");
  run("click curves.copy\n");
  const std::string csv = ImGui::GetClipboardText();
  EXPECT_NE(csv.find("solvent radius (Å),pocket 4\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n5,\n"), std::string::npos) << "a gap is empty";
  EXPECT_NE(csv.find("# sha256: "), std::string::npos);
  EXPECT_NE(csv.find("# values: SA area (Å²)\n"), std::string::npos);
  const fs::path path = folder_ / "curve.csv";
  run("click curves.save\nframes 3\n");
  viewer_->state().save_table.path = path.string();
  run("click save_table.ok\n");
  settle();
  EXPECT_EQ(bytes("curve.csv"), csv);
  run("click curves.save\nframes 3\n");
  viewer_->state().save_table.path = (folder_ / "curve.svg").string();
  run("click save_table.ok\n");
  settle();
  const std::string svg = bytes("curve.svg");
  EXPECT_EQ(test::xml_error(svg), "") << svg;
  EXPECT_NE(svg.find("SA area (Å²)"), std::string::npos);
  EXPECT_NE(svg.find("pocket 4"), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
}

TEST_F(CurvesTest, WhileTheSolventRadiusMovesEachTableAddsItsPointToTheTotals) {
  open_haemoglobin();
  open_curves_cancelled();
  ASSERT_TRUE(has("curves.plot")) << "the table on screen is a point";
  std::map<double, double> seen;  // by radius: the sum over all pockets
  drag_solvent({1.4, 1.55, 1.7, 1.6}, [&] {
    ASSERT_TRUE(has("curves.plot"));
    EXPECT_FALSE(memory().curves) << "nothing but points";
    ASSERT_EQ(memory().chart.chart.series.size(), 2u);
    const CavityTable& table = page().rows.table();
    seen[radius_set()] = table.volume_sa_angstrom3(false);
    const auto value = value_at(1, radius_set());
    ASSERT_TRUE(value) << radius_set();
    EXPECT_NEAR(*value, seen[radius_set()], 1e-9 * seen[radius_set()]);
    EXPECT_TRUE(std::is_sorted(series(1).x.begin(), series(1).x.end()));
  });
  settle();
  ASSERT_GE(seen.size(), 4u);
  for (const auto& [radius, volume] : seen) EXPECT_NEAR(*value_at(1, radius), volume, 1e-6);
  const std::size_t points = series(1).x.size();
  EXPECT_EQ(memory().chart.traced, std::vector<bool>(points, true));
  run("click curves.copy\n");
  const std::string csv = ImGui::GetClipboardText();
  EXPECT_NE(csv.find("# radii: those of tables on screen\n"), csv.npos) << csv;
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv.substr(csv.find("\nsolvent")), '\n')),
            points + 2);
  // Undo brings back a radius that is there already.
  run("edit.undo\n");
  settle();
  EXPECT_EQ(radius_set(), 1.4);
  EXPECT_EQ(series(1).x.size(), points);
  // A curve fills the rest.
  run("click curves.again\n");
  settle();
  EXPECT_TRUE(memory().curves);
  EXPECT_EQ(series(1).x.front(), 0);
  EXPECT_EQ(series(1).x.back(), 5);
  EXPECT_GE(series(1).x.size(), 51u);
  for (const auto& [radius, volume] : seen) EXPECT_NEAR(*value_at(1, radius), volume, 1e-6);
  EXPECT_EQ(std::adjacent_find(series(1).x.begin(), series(1).x.end()), series(1).x.end());
}

TEST_F(CurvesTest, PartsOfNetworksAreNoPointsOfACurveOfWholeCavities) {
  open_haemoglobin();
  run("solvent.set 0.5\nwait-idle\n");
  open_curves();
  EXPECT_FALSE(memory().chart.traced.empty());
  run("cavities.split_networks on\n");
  settle();
  run("click bottom.cavities\n");
  settle();
  EXPECT_FALSE(page().rows.table().found.networks.empty()) << "or this shows nothing";
  run("click bottom.curves\n");
  settle();
  ASSERT_TRUE(memory().curves && memory().trace);
  EXPECT_TRUE(memory().trace->question.split_networks);
  EXPECT_TRUE(memory().chart.traced.empty());
  EXPECT_EQ(series(1).x.size(), 51u);
}

TEST_F(CurvesTest, PointsOfAChosenCavityAreThoseOfItsNumberAndBeginAnewWithAlphaAndFile) {
  open_haemoglobin();
  run("click cavities.row.4 0.2\n");
  settle();
  open_curves_cancelled();
  const auto first = page().rows.lines;
  const std::uint32_t number = first->numbers->of[first->table->order[3]];
  drag_solvent({1.4, 1.5, 1.6}, [&] {
    ASSERT_EQ(memory().chart.chart.series.size(), 1u);
    const auto lines = page().rows.lines;
    const std::uint32_t cavity = lines->numbers->cavity(number);
    ASSERT_NE(cavity, CavityMatch::kNone);
    EXPECT_EQ(value_at(0, radius_set()), lines->table->measures[cavity].volume_sa_angstrom3);
  });
  settle();
  EXPECT_GE(series(0).x.size(), 3u);
  EXPECT_EQ(value_at(0, 1.4), first->table->measure(3).volume_sa_angstrom3);
  run("click curves.quantity.1\n");
  settle();
  EXPECT_EQ(value_at(0, 1.4), first->table->measure(3).area_sa_angstrom2);
  run("click curves.quantity.3\n");
  settle();
  const std::size_t mouths = first->table->cavity(3).mouths.size();
  EXPECT_GT(mouths, 0u);
  EXPECT_EQ(value_at(0, 1.4), static_cast<double>(mouths));
  run("alpha.set 0.3\n");
  settle();
  ASSERT_TRUE(memory().trace);
  EXPECT_EQ(memory().trace->points.size(), 1u) << "another alpha";
  EXPECT_EQ(std::ranges::count(memory().chart.traced, true), 1);
  EXPECT_TRUE(memory().curves) << "the new curve is not cancelled";
  run("open " + crambin().string() + "\nwait-idle\n");
  settle();
  ASSERT_TRUE(memory().trace || memory().curves);
  if (memory().trace) EXPECT_EQ(memory().trace->points.size(), 1u) << "another file";
}

// The page of cavities is not drawn meanwhile.
TEST_F(CurvesTest, AChosenCavityIsFollowedWhenTheTetrahedronOfItsSinkIsGone) {
  open_haemoglobin();
  const CavityPage& page = *viewer_->state().cavities.page;
  const auto lines = page.rows.lines;
  const auto set_radius = [&](const char* angstrom) {
    run(std::string("solvent.set ") + angstrom + "\n");
    settle();
  };
  set_radius("1.6");
  // A cavity that still exists although the tetrahedron of its sink does not.
  const auto& others = page.rows.table().ground->triangulation->tetrahedra;
  const CavityTable& table = *lines->table;
  std::optional<std::size_t> row;
  for (std::size_t n = 0; n < table.size() && !row; ++n) {
    const auto& sink = table.ground->triangulation->tetrahedra[table.cavity(n).deepest_sink];
    const std::uint32_t number = lines->numbers->of[table.order[n]];
    const bool stays = page.rows.lines->numbers->cavity(number) != CavityMatch::kNone;
    if (stays && !std::binary_search(others.begin(), others.end(), sink)) row = n;
  }
  ASSERT_TRUE(row) << "or this shows nothing";
  set_radius("1.4");
  viewer_->state().settings.selection.cavities = RefSet({cavity_sink(*lines->atoms, table, *row)});
  settle();
  open_curves();
  for (const char* radius : {"1.5", "1.6"}) {
    set_radius(radius);
    ASSERT_EQ(page.selected_rows.size(), 1u) << radius;
    ASSERT_EQ(memory().chart.chart.series.size(), 1u) << radius;
    EXPECT_FALSE(viewer_->state().layers.empty()) << "it is seen in the view";
  }
}

TEST_F(CurvesTest, ExactVolumesAreMadeOnRequestAndCanBeCancelled) {
  open_haemoglobin();
  run("click cavities.row.4 0.2\n");
  settle();
  const CavityPage& page = *viewer_->state().cavities.page;
  ASSERT_TRUE(page.rows.exact);
  const std::uint32_t cavity = page.rows.table().order[3];
  const double exact = page.rows.exact->of[cavity].volume_sa_angstrom3;
  open_curves();
  const double sum = *series(0).values[14];
  run("click curves.quantity.2\nframes 4\n");
  ASSERT_TRUE(has("curves.cancel"));
  run("click curves.cancel\nframes 3\n");
  ASSERT_TRUE(has("curves.again"));
  EXPECT_EQ(memory().chart_quantity, 0) << "the old chart stays, grey";
  run("click curves.again\n");
  settle();
  EXPECT_EQ(memory().chart.chart.value_label, "exact volume (Å³)");
  EXPECT_EQ(*series(0).values[14], exact);
  EXPECT_NE(exact, sum);
}

TEST_F(CurvesTest, LivesAreBarsAndAClickChoosesACavityThatIsThereOrGoesToWhereItIs) {
  open_haemoglobin();
  open_curves();
  run("click curves.quantity.4\n");
  settle();
  ASSERT_TRUE(has("curves.lives"));
  EXPECT_FALSE(has("curves.plot"));
  EXPECT_FALSE(has("curves.axis.0")) << "only alpha";
  const CavityPage& page = *viewer_->state().cavities.page;
  const ShownLives& lives = memory().lives;
  ASSERT_GT(lives.bars.longest.size(), 50u);
  ASSERT_EQ(lives.rows.size(), lives.bars.longest.size());
  std::optional<std::size_t> there, other;
  for (std::size_t k = 0; k < 15; ++k) {
    const bool is_there = lives.rows[k] != ShownLives::kNoRow;
    EXPECT_EQ(is_there, lives.bars.longest[k].is_at(0)) << k;
    if (is_there && !there) there = k;
    if (!is_there && !other) other = k;
  }
  ASSERT_TRUE(there && other) << "or this shows nothing";
  const auto click = [&](std::size_t bar) {
    run("click curves.life." + std::to_string(bar + 1) + "\n");
    settle();
  };
  click(*there);
  ASSERT_EQ(page.selected_rows, std::vector<std::size_t>{lives.rows[*there]});
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0);
  EXPECT_FALSE(viewer_->state().layers.empty()) << "it is seen in the view";
  const std::uint32_t sink = lives.bars.longest[*other].sink;
  click(*other);
  const double alpha = viewer_->state().settings.request.alpha_angstrom2;
  EXPECT_NE(alpha, 0);
  EXPECT_TRUE(lives.bars.longest[*other].is_at(alpha));
  ASSERT_EQ(page.selected_rows.size(), 1u);
  EXPECT_EQ(page.rows.table().cavity(page.selected_rows.front()).deepest_sink, sink);
  run("edit.undo\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0) << "in one step";
  ASSERT_EQ(page.selected_rows, std::vector<std::size_t>{lives.rows[*there]});
}

TEST_F(CurvesTest, ADragOverLivesSetsAlphaAsOneEntryAndTheirTableIsSaved) {
  open_haemoglobin();
  open_curves();
  run("click curves.quantity.4\n");
  settle();
  ASSERT_TRUE(has("curves.lives"));
  const std::string undo = viewer_->state().undo_text;
  run("move curves.lives 0.3\ndown\nmove curves.lives 0.4\nmove curves.lives 0.5\nup\n");
  settle();
  const double alpha = viewer_->state().settings.request.alpha_angstrom2;
  EXPECT_GT(alpha, 0);
  EXPECT_EQ(std::round(alpha * 100) / 100, alpha);
  EXPECT_TRUE(viewer_->state().settings.selection.cavities.empty())
      << "nothing is chosen by a drag";
  run("edit.undo\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, 0);
  EXPECT_EQ(viewer_->state().undo_text, undo);
  run("click curves.copy\n");
  const std::string csv = ImGui::GetClipboardText();
  EXPECT_NE(csv.find("# sha256: "), std::string::npos);
  EXPECT_NE(csv.find("# solvent radius: 1.4 Å\n"), std::string::npos);
  EXPECT_NE(csv.find("\nborn_alpha_angstrom2,closed_alpha_angstrom2,gone_alpha_angstrom2,name\n"),
            std::string::npos)
      << csv.substr(0, 2000);
  run("click curves.save\nframes 3\n");
  viewer_->state().save_table.path = (folder_ / "lives.csv").string();
  run("click save_table.ok\n");
  settle();
  EXPECT_EQ(bytes("lives.csv"), csv);
}

TEST_F(CurvesTest, ModelsArePlottedAndAClickShowsOne) {
  std::string text;
  {
    std::ifstream file(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb");
    std::string atoms, line;
    while (std::getline(file, line)) {
      if (line.substr(0, 5) == "ATOM ") atoms += line + "\n";
    }
    for (int k = 1; k <= 3; ++k)
      text += "MODEL        " + std::to_string(k) + "\n" + atoms + "ENDMDL\n";
  }
  const auto path = std::filesystem::temp_directory_path() / "alphascope-curves-models.pdb";
  std::ofstream(path) << text << "END\n";
  run("open " + path.string() + "\nwait-idle\nsolvent.set 0.8\nwait-idle\n");
  open_curves();
  run("click curves.axis.2\n");
  settle();
  ASSERT_TRUE(has("curves.plot"));
  ASSERT_EQ(series(1).x.size(), 3u);
  EXPECT_EQ(*series(1).values[0], *series(1).values[2]);
  run("click curves.plot 0.99\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.open.balls.model, 2);
  EXPECT_TRUE(has("curves.plot"));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace alphascope::testing
