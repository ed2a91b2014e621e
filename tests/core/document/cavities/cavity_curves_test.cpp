// SPDX-License-Identifier: GPL-3.0-or-later
// Tests curves of cavities: each sample is the table of its setting, and lines follow cavities.
#include "core/document/cavities/cavity_curve_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = CavityMatch::kNone;

std::shared_ptr<const CavityGround> ground_of(const BallSet& balls) {
  return std::make_shared<const CavityGround>(
      make_cavity_ground(std::make_shared<const BallSet>(balls),
                         std::make_shared<const Triangulation>(make_triangulation(balls, 1))));
}

// A box with an inner wall that has a hole: two chambers, which are one while the hole is open.
// Radius 4 closes the hole.
BallSet two_chambers() {
  BallSet balls;
  balls.lattice.digits = 0;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 4; ++y) {
      for (int z = 0; z <= 4; ++z) {
        const bool shell = x == 0 || x == 10 || y == 0 || y == 4 || z == 0 || z == 4;
        const bool hole = y == 2 && z == 2;
        if (shell || (x == 4 && !hole)) testing::add_ball(balls, 4 * x, 4 * y, 4 * z, 3);
      }
    }
  }
  return balls;
}

TEST(CavityCurves, ARadiusThatSplitsAVoidEndsTheSmallerOnesLine) {
  const BallSet balls = two_chambers();
  const CavityCurves curves = curves_against_solvent(balls, 0, {0, 0.5, 1, 1.5, 2, 6});
  ASSERT_EQ(curves.samples.size(), 6u);
  EXPECT_EQ(curves.samples[1].cavities.size(), 1u);
  EXPECT_EQ(curves.samples[3].cavities.size(), 2u);
  EXPECT_TRUE(curves.samples[5].cavities.empty());
  const BallSet grown = with_solvent(balls, 2);
  const CavityTable table = make_cavity_table(ground_of(grown), {0, 2});
  ASSERT_EQ(table.voids, 2u);
  const CurveLinks links = link_curves(curves, table, 2);
  const std::vector<std::uint32_t>& large = links.of[table.order[0]];
  const std::vector<std::uint32_t>& small = links.of[table.order[1]];
  for (std::size_t n = 0; n < 5; ++n) EXPECT_NE(large[n], kNone) << n;
  EXPECT_EQ(large[5], kNone);
  EXPECT_EQ(small[1], kNone) << "there it is a part of the larger one";
  EXPECT_NE(small[4], kNone);
  for (std::size_t n = 0; n + 1 < 5; ++n) {
    EXPECT_GT(curves.samples[n].cavities[large[n]].volume_sa_angstrom3,
              curves.samples[n + 1].cavities[large[n + 1]].volume_sa_angstrom3);
  }
  std::size_t splits = 0;
  for (std::size_t n = 1; n < 5; ++n) splits += parts_at(curves.samples[n], large[n - 1]) == 2;
  EXPECT_EQ(splits, 1u);
  EXPECT_EQ(sources_at(curves.samples[1], large[1]), 1u);
  // A radius between or beyond the samples has a nearest sample.
  EXPECT_EQ(curves.nearest(1.9), 4u);
  EXPECT_EQ(curves.nearest(-3), 0u);
}

TEST(CavityCurves, ExactVolumesAreThoseOfEachTable) {
  const BallSet balls = *testing::sample_balls("1crn.pdb");
  const CavityCurves curves = curves_against_solvent(balls, 0, {0.6, 1}, {}, CurveNumbers::exact);
  const auto ground = ground_of(with_solvent(balls, 1));
  const CavityTable table = make_cavity_table(ground, {0, 1});
  const std::vector<ExactCavityMeasures> exact = measure_all_exactly(table);
  ASSERT_GT(table.pockets, 0u);
  ASSERT_EQ(curves.samples[1].cavities.size(), exact.size());
  bool differs = false;  // else it could be the other number
  for (std::size_t c = 0; c < exact.size(); ++c) {
    const CurveCavity& cavity = curves.samples[1].cavities[c];
    EXPECT_EQ(cavity.volume_exact_angstrom3, exact[c].volume_sa_angstrom3);
    differs |= cavity.volume_exact_angstrom3 != cavity.volume_sa_angstrom3;
  }
  EXPECT_TRUE(differs);
  const CavityCurves alphas = curves_against_alpha(ground, 1, {-0.1, 0}, {}, CurveNumbers::exact);
  for (std::size_t c = 0; c < exact.size(); ++c) {
    EXPECT_EQ(alphas.samples[1].cavities[c].volume_exact_angstrom3, exact[c].volume_sa_angstrom3);
  }
  const CavityChart chart = chart_of_totals(curves, CurveQuantity::exact_volume);
  EXPECT_EQ(chart.chart.value_label, "exact volume (Å³)");
  double sum = 0;
  for (std::size_t c = 0; c < exact.size(); ++c) {
    if (!table.found.cavities[c].is_void()) sum += exact[c].volume_sa_angstrom3;
  }
  EXPECT_EQ(*chart.chart.series[1].values[1], sum);
}

TEST(CavityChart, SaysWhereACavitySplitsAndLeavesGaps) {
  const BallSet balls = two_chambers();
  const CavityCurves curves = curves_against_solvent(balls, 0, {0, 0.5, 1, 1.5, 2, 6});
  const CavityTable table = make_cavity_table(ground_of(with_solvent(balls, 2)), {0, 2});
  const CurveLinks links = link_curves(curves, table, 2);
  const CavityChart chart =
      chart_of_cavities(curves, CurveQuantity::volume, links,
                        {{table.order[0], "void 1"}, {table.order[1], "void 2"}});
  ASSERT_EQ(chart.marks.size(), 2u);
  EXPECT_EQ(chart.marks[0].text, "Between 0.5 and 1 Å it splits into 2 cavities.");
  EXPECT_EQ(chart.marks[0].sample, 2u);
  EXPECT_EQ(chart.marks[1].text, "Below 1 Å it is a part of a larger cavity.");
  EXPECT_EQ(chart.marks[1].series, 1u);
  const std::vector<ChartSeries>& series = chart.chart.series;
  EXPECT_EQ(series[0].values[4], table.measure(0).volume_sa_angstrom3);
  EXPECT_FALSE(series[1].values[1]);
  const std::string csv = chart_csv(chart.chart, {"file: a.pdb"});
  EXPECT_EQ(csv.substr(0, csv.find("\n0,")), "# file: a.pdb\nsolvent radius (Å),void 1,void 2");
  EXPECT_EQ(csv.substr(csv.rfind("\n6")), "\n6,,\n");
  const CavityChart totals = chart_of_totals(curves, CurveQuantity::area);
  ASSERT_EQ(totals.chart.series.size(), 2u);
  EXPECT_NEAR(*totals.chart.series[0].values[4], table.area_sa_angstrom2(true), 1e-9);
  EXPECT_EQ(totals.chart.series[1].values[4], 0);
  EXPECT_EQ(totals.chart.value_label, "SA area (Å²)");
}

// The hand goes from 2 to 0.75 and to 1: the second void becomes a part of the first, and parts.
TEST(CavityChart, PointsOfATraceLieAmongTheSamplesOfACurve) {
  const BallSet balls = two_chambers();
  CavityNumbers numbers;
  std::shared_ptr<const CavityTrace> trace;
  for (const double radius : {2.0, 0.75, 1.0}) {
    const auto table = std::make_shared<const CavityTable>(
        make_cavity_table(ground_of(with_solvent(balls, radius)), {0, radius}));
    numbers = numbers.table ? next_numbers(numbers, table) : first_numbers(table);
    trace = next_trace(trace.get(), numbers);
  }
  const CavityTable& table = *numbers.table;
  ASSERT_EQ(table.voids, 2u);
  const std::vector<TracedSeries> chosen = {{numbers.of[table.order[0]], "void 1"},
                                            {numbers.of[table.order[1]], "void 2"}};
  const CavityChart points = chart_of_trace(*trace, CurveQuantity::volume, chosen);
  ASSERT_EQ(points.chart.series.size(), 2u);
  EXPECT_EQ(points.chart.series[1].x, (std::vector<double>{0.75, 1, 2}));
  EXPECT_EQ(points.chart.x_label, "solvent radius (Å)");
  EXPECT_FALSE(points.chart.series[1].values[0]) << "there it is a part of the larger one";
  EXPECT_EQ(points.chart.series[1].values[1], table.measure(1).volume_sa_angstrom3);

  const CavityCurves curves = curves_against_solvent(balls, 0, {0, 0.5, 1, 1.5});
  const CavityChart whole =
      chart_of_cavities(curves, CurveQuantity::volume, link_curves(curves, table, 1),
                        {{table.order[0], "void 1"}, {table.order[1], "void 2"}});
  const CavityChart both = with_trace(whole, points);
  const std::vector<ChartSeries>& series = both.chart.series;
  EXPECT_EQ(series[0].x, (std::vector<double>{0, 0.5, 0.75, 1, 1.5, 2}));
  EXPECT_EQ(series[1].x, series[0].x);
  EXPECT_EQ(both.traced, (std::vector<bool>{false, false, true, true, false, true}));
  for (std::size_t n = 0; n + 1 < series[0].x.size(); ++n) {
    ASSERT_TRUE(series[0].values[n] && series[0].values[n + 1]);
    EXPECT_GT(*series[0].values[n], *series[0].values[n + 1]) << "it is one cavity";
  }
  ASSERT_EQ(both.marks.size(), whole.marks.size());
  ASSERT_FALSE(both.marks.empty());
  for (std::size_t k = 0; k < both.marks.size(); ++k) {
    EXPECT_EQ(series[0].x[both.marks[k].sample], whole.chart.series[0].x[whole.marks[k].sample]);
  }
  EXPECT_TRUE(chart_of_trace(*trace, CurveQuantity::exact_volume, chosen).chart.empty());
  const CavityChart sums = with_trace(chart_of_totals(curves, CurveQuantity::area),
                                      totals_of_trace(*trace, CurveQuantity::area));
  EXPECT_EQ(sums.chart.series[0].x, series[0].x);
  EXPECT_EQ(sums.chart.series[0].values[5], trace->points.back()->voids.area_sa_angstrom2);
  EXPECT_EQ(sums.chart.series[0].name, "all voids");
}

TEST(CavityCurves, OverAlphaACavityIsThereFromBirthToEnd) {
  const auto ground = ground_of(two_chambers());
  const CavityCurves curves = curves_against_alpha(ground, 0, {0, 4, 8, 16, 30, 300});
  const CavityTable table = make_cavity_table(ground, {16, 0});
  ASSERT_EQ(table.voids, 2u);
  const CurveLinks links = link_curves(curves, table, 16);
  std::size_t whole = 0, from_split = 0;
  for (const std::vector<std::uint32_t>& line : links.of) {
    EXPECT_NE(line[3], kNone);
    EXPECT_EQ(line[5], kNone);
    (line[0] != kNone ? whole : from_split) += 1;
  }
  EXPECT_EQ(whole, 1u);
  EXPECT_EQ(from_split, 1u);
}

struct Shown {
  Inputs inputs;
  std::shared_ptr<const CavityTable> table;
};

Shown shown(const std::shared_ptr<const Molecule>& molecule, int model, double solvent,
            double alpha) {
  BallOptions options = cavity_body({}, false);
  options.model = model;
  const auto prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, options));
  Shown s;
  s.inputs.atoms = std::make_shared<const BallReferences>(molecule, prepared);
  s.inputs.balls = std::make_shared<const BallSet>(with_solvent(*prepared->balls, solvent));
  s.inputs.balls_key = s.inputs.body_key = static_cast<std::uint64_t>(model) + 1;
  s.inputs.frames_key = key_of_frames(*s.inputs.atoms);
  s.inputs.solvent_radius_angstrom = solvent;
  s.inputs.alpha_angstrom2 = alpha;
  s.table = std::make_shared<const CavityTable>(
      make_cavity_table(ground_of(*s.inputs.balls), {alpha, solvent}));
  return s;
}

void expect_sample_of(const CurveSample& sample, const CavityTable& table) {
  ASSERT_EQ(sample.cavities.size(), table.found.cavities.size());
  for (std::size_t c = 0; c < sample.cavities.size(); ++c) {
    EXPECT_EQ(sample.cavities[c].volume_sa_angstrom3, table.measures[c].volume_sa_angstrom3);
    EXPECT_EQ(sample.cavities[c].area_sa_angstrom2, table.measures[c].area_sa_angstrom2);
    EXPECT_EQ(sample.cavities[c].is_void, table.found.cavities[c].is_void());
    EXPECT_EQ(sample.cavities[c].mouths, table.found.cavities[c].mouths.size());
  }
}

struct CavityCurveResults : testing::StoreTest {
  template <class T>
  std::shared_ptr<const T> made_by_store(const Definition<T>& definition, const Inputs& in) {
    for (int i = 0; i < 60'000; ++i) {
      const Derived<T> d = store.want(definition, in);
      if (d.ready()) return d.value;
      if (d.state == DerivedState::failed || d.state == DerivedState::no_room) {
        ADD_FAILURE() << d.why;
        return nullptr;
      }
      frame();
      std::this_thread::sleep_for(kShort);
    }
    ADD_FAILURE() << "not made in a minute";
    return nullptr;
  }
  void SetUp() override { budget = 1'000'000'000; }
};

TEST_F(CavityCurveResults, SamplesOfCrambinAreItsTables) {
  const auto molecule = std::make_shared<const Molecule>(
      read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb"));
  const Shown s = shown(molecule, 0, 0.8, 0.5);
  const auto solvent = made_by_store(curves_over_solvent(), s.inputs);
  const auto alpha = made_by_store(curves_over_alpha(), s.inputs);
  ASSERT_TRUE(solvent && alpha);
  ASSERT_EQ(solvent->samples.size(), 51u);
  EXPECT_EQ(solvent->samples[8].at, 0.8);
  expect_sample_of(solvent->samples[8], *s.table);
  expect_sample_of(solvent->samples[12], *shown(molecule, 0, 1.2, 0.5).table);
  const std::size_t half = alpha->nearest(0.5);
  EXPECT_EQ(alpha->samples[half].at, 0.5);
  EXPECT_EQ(alpha->samples.front().at, -3);
  expect_sample_of(alpha->samples[half], *s.table);
  EXPECT_TRUE(alpha->samples.back().cavities.empty()) << "the last cavity is filled";
  // In both curves each cavity on screen is itself at its own place.
  for (const auto& curves : {solvent, alpha}) {
    const auto key = Key{1, curves == alpha ? 1u : 2u, 0};
    const auto links = made_by_store(curve_links(curves, key), s.inputs);
    ASSERT_TRUE(links);
    ASSERT_EQ(links->of.size(), s.table->found.cavities.size());
    const std::size_t here = curves == alpha ? half : 8;
    for (std::uint32_t c = 0; c < links->of.size(); ++c) EXPECT_EQ(links->of[c][here], c);
  }
  // Another solvent radius needs the same curve.
  const Shown other = shown(molecule, 0, 1.2, 0.5);
  EXPECT_TRUE(store.want(curves_over_solvent(), other.inputs).ready());
  EXPECT_EQ(why_no_model_curve(s.inputs), "This file has one model only.");
}

// Two models of crambin. The second is shifted, or has another atom name.
std::shared_ptr<const Molecule> two_models(bool renamed) {
  std::ifstream file(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb");
  std::string atoms, moved, line;
  while (std::getline(file, line)) {
    if (line.substr(0, 5) != "ATOM ") continue;
    atoms += line + "\n";
    char x[16];
    std::snprintf(x, sizeof x, "%8.3f", std::stod(line.substr(30, 8)) + 1.5);
    line.replace(30, 8, x);
    if (renamed && moved.empty()) line.replace(13, 2, "NX");
    moved += line + "\n";
  }
  return std::make_shared<const Molecule>(
      read_text("two.pdb",
                "MODEL        1\n" + atoms + "ENDMDL\nMODEL        2\n" + moved + "ENDMDL\nEND\n"));
}

TEST_F(CavityCurveResults, ExactVolumesHaveNoMoreSamplesUpToTheSameEnd) {
  const auto molecule = std::make_shared<const Molecule>(
      read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb"));
  const Shown s = shown(molecule, 0, 0.8, 0.5);
  const auto sums = made_by_store(curves_over_alpha(), s.inputs);
  const auto exact = made_by_store(curves_over_alpha(CurveNumbers::exact), s.inputs);
  ASSERT_TRUE(sums && exact);
  ASSERT_GT(exact->samples.size(), 2u);
  EXPECT_LE(exact->samples.size(), sums->samples.size());
  // Both continue to the first sample at which the last cavity is filled.
  EXPECT_GE(exact->samples.back().at, sums->samples.end()[-2].at);
  EXPECT_LT(exact->samples.end()[-2].at, sums->samples.back().at);
}

TEST_F(CavityCurveResults, ModelsAreMatchedByTheirAtomsWhicheverIsOnScreen) {
  const auto molecule = two_models(false);
  const Shown first = shown(molecule, 0, 0.8, 0), second = shown(molecule, 1, 0.8, 0);
  EXPECT_EQ(first.inputs.frames_key, second.inputs.frames_key);
  EXPECT_NE(first.inputs.frames_key, 0u);
  EXPECT_EQ(why_no_model_curve(first.inputs), "");
  EXPECT_EQ(shown_model(*second.inputs.atoms), 1u);
  const auto curves = made_by_store(curves_over_models(), first.inputs);
  ASSERT_TRUE(curves);
  ASSERT_EQ(curves->samples.size(), 2u);
  EXPECT_TRUE(store.want(curves_over_models(), second.inputs).ready());
  ASSERT_EQ(curves->samples[1].cavities.size(), curves->samples[0].cavities.size());
  const CurveLinks links = link_curves(*curves, *second.table, 1);
  ASSERT_GT(links.of.size(), 5u);
  for (std::uint32_t c = 0; c < links.of.size(); ++c) {
    EXPECT_EQ(links.of[c], (std::vector<std::uint32_t>{c, c}));
  }
}

TEST_F(CavityCurveResults, AModelOfOtherAtomsIsAGap) {
  const Shown s = shown(two_models(true), 0, 0.8, 0);
  const auto curves = made_by_store(curves_over_models(), s.inputs);
  ASSERT_TRUE(curves);
  EXPECT_TRUE(curves->samples[0].known);
  EXPECT_FALSE(curves->samples[1].known);
  const CurveLinks links = link_curves(*curves, *s.table, 0);
  for (const auto& line : links.of) EXPECT_EQ(line[1], kNone);
}

TEST_F(CavityCurveResults, CanBeCancelled) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(curves_against_solvent(two_chambers(), 0, {0, 1}, context), Cancelled);
  EXPECT_THROW(curves_against_alpha(ground_of(two_chambers()), 0, {0, 1}, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
