// SPDX-License-Identifier: GPL-3.0-or-later
// Tests Part I of the thesis' suite: its rows, their table, and its limits.
#include "app/bench/rounds_suite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/geometry/ball_set.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using Kind = RoundsRow::Kind;

ThesisOptions quick_options() {
  ThesisOptions options;
  options.threads = 2;
  options.repeats = 2;
  options.seconds_per_row = 60;
  return options;
}

std::vector<ThesisMolecule> crambin() {
  return {{"1crn", testing::sample_balls("1crn.pdb"), {{"file", "1crn.pdb"}}}};
}

std::map<std::string, std::string> cells_of(const RoundsReport& report, std::size_t n) {
  const std::vector<CsvRow> rows = rounds_csv(report);
  return {rows.at(n).begin(), rows.at(n).end()};
}

TEST(RoundsSuite, HasARowForEachRoundAndForEachWhole) {
  std::size_t told = 0;
  const RoundsReport report =
      run_rounds_suite(crambin(), quick_options(), nullptr, {},
                       [&](std::span<const RoundsRow> rows) { told += rows.size(); });
  EXPECT_EQ(told, report.rows.size());
  EXPECT_TRUE(report.all_same());
  ASSERT_GT(report.rows.size(), 6u);
  const std::size_t completion = report.rows.size() - 4;
  std::size_t before = 0;
  for (std::size_t n = 0; n <= completion; ++n) {
    const RoundsRow& row = report.rows[n];
    EXPECT_EQ(row.kind, n < completion ? Kind::round : Kind::completion);
    EXPECT_EQ(row.number, n < completion ? n + 1 : 0);
    EXPECT_GE(row.step.saturated, before);
    EXPECT_EQ(row.runs, 2);
    EXPECT_GT(row.milliseconds, 0);
    before = row.step.saturated;
  }
  const RoundsRow& ours = report.rows[completion + 1];
  EXPECT_EQ(ours.maker, kThesisRoundsName);
  EXPECT_EQ(ours.step.saturated, before);
  EXPECT_DOUBLE_EQ(*ours.saturated_share(), static_cast<double>(before) / 327);
  EXPECT_EQ(report.rows[completion + 2].maker.find("usual way: "), 0u);
  EXPECT_EQ(report.rows[completion + 3].maker, "CGAL");
  for (std::size_t n = completion + 1; n < report.rows.size(); ++n) {
    EXPECT_EQ(report.rows[n].kind, Kind::whole);
    EXPECT_EQ(report.rows[n].step.tetrahedra, report.rows[completion].step.tetrahedra);
    EXPECT_EQ(report.rows[n].same_as_cgal, true);
  }
  auto first = cells_of(report, 0), last = cells_of(report, report.rows.size() - 1);
  EXPECT_EQ(first["kind"], "round");
  EXPECT_EQ(first["maker"], "the thesis' rounds");
  EXPECT_EQ(first["alpha_angstrom2"], "2.5");
  EXPECT_EQ(first["computed_balls"], "327");
  EXPECT_EQ(first["file"], "1crn.pdb");
  EXPECT_EQ(last["alpha_angstrom2"], "") << "no alpha is no zero";
  EXPECT_EQ(last["saturated_share"], "");
  EXPECT_EQ(last["same_as_cgal"], "1");
}

TEST(RoundsSuite, OfBallsInAPlaneHasNoRound) {
  auto balls = std::make_shared<BallSet>();
  balls->centres = {{0, 0, 0}, {3000, 0, 0}, {0, 3000, 0}, {3000, 4000, 0}};
  balls->radii = {2000, 2000, 2000, 2000};
  const RoundsReport report = run_rounds_suite({{"flat", balls, {}}}, quick_options(), nullptr, {});
  ASSERT_EQ(report.rows.size(), 3u);
  EXPECT_EQ(report.rows[0].kind, Kind::whole);
  EXPECT_EQ(report.rows[0].step.saturated, 0u);
  EXPECT_EQ(report.rows[0].step.unsaturated, 4u);
  EXPECT_TRUE(report.all_same());
}

TEST(RoundsSuite, WhatTakesTooLongIsLeftOut) {
  testing::Random random(3);
  const auto many =
      std::make_shared<const BallSet>(testing::random_balls(random, 100'000, 300, 1, 6));
  ThesisOptions options = quick_options();
  options.seconds_per_row = 1e-9;
  const RoundsReport report = run_rounds_suite({{"many", many, {}}}, options, nullptr, {});
  ASSERT_EQ(report.rows.size(), 3u);
  for (const RoundsRow& row : report.rows) {
    EXPECT_EQ(row.skipped, "over 1e-09 s") << row.maker;
    EXPECT_FALSE(row.same_as_cgal);
  }
  EXPECT_EQ(cells_of(report, 0)["tetrahedra"], "");
  EXPECT_TRUE(report.all_same()) << "nothing differs";
}

TEST(RoundsSuite, CanBeCancelled) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(run_rounds_suite(crambin(), quick_options(), nullptr, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
