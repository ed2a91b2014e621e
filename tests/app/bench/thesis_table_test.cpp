// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the suite's table and figures with rows of known numbers.
#include "app/bench/thesis_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/bench/thesis_charts.hpp"
#include "app/bench/thesis_contest.hpp"
#include "tests/app/session/fake_engine.hpp"

namespace alphascope {
namespace {

using Kind = ThesisRow::Kind;

TEST(ThesisCells, OfAnEvenNumberOfTimesTheMedianIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(median({3, 9, 1}), 3);
  EXPECT_EQ(median({8, 1, 9, 3}), 5.5);
}

TEST(ThesisCells, WhatIsNoNumberIsAnEmptyField) {
  EXPECT_EQ(shortest_cell(std::nan("")), "");
  EXPECT_EQ(shortest_cell(HUGE_VAL), "");
  EXPECT_EQ(shortest_cell(CellValue()), "");
  EXPECT_EQ(shortest_cell(0.1), "0.1") << "no further digits";
}

ThesisRow row(Kind kind, EngineChoice choice, double alpha, double cold) {
  ThesisRow r;
  r.kind = kind;
  r.choice = choice;
  r.molecule = "few";
  r.balls = 12;
  r.alpha_angstrom2 = alpha;
  r.runs = 3;
  r.cold_milliseconds = cold;
  r.warm_milliseconds = cold / 2;
  r.cgal_cold_milliseconds = 40;
  r.tetrahedra = 25;
  r.full_tetrahedra = 100;
  r.hash = 0xabc;
  r.same_as_cgal = true;
  r.stage_medians = {{"kernel I (candidates)", 3, false}, {"grid", 1, false}};
  r.stages.kernel1 = 3;
  r.stages.other = 1;
  return r;
}

ThesisReport known_report() {
  ThesisReport report;
  report.options.alphas = {0, 1};
  report.options.engines = {EngineChoice::tuples_cpu};
  report.machine.cpu = "Some CPU";
  report.machine.threads = 2;
  report.program = "Alphascope test";
  report.molecules = {{"few", test::few_balls(12), {{"file", "few, too.xyzr"}}}};
  report.rows.push_back(row(Kind::cgal, EngineChoice::cgal, 0, 40));
  report.rows.push_back(row(Kind::engine, EngineChoice::tuples_cpu, 0, 10));
  ThesisRow off = row(Kind::ablation, EngineChoice::tuples_cpu, 0, 40);
  off.variant = "without edge optimisation";
  report.rows.push_back(off);
  ThesisRow slow;
  slow.choice = EngineChoice::tuples_cpu;
  slow.molecule = "few";
  slow.alpha_angstrom2 = 1;
  slow.skipped = "over 20 s";
  slow.too_slow = true;
  slow.cgal_cold_milliseconds = 40;
  report.rows.push_back(slow);
  report.break_even = {{0, EngineChoice::tuples_cpu, 0.0, false, 1.0}};
  return report;
}

std::map<std::string, std::string> csv_row(const ThesisReport& report, std::size_t n) {
  const std::vector<CsvRow> rows = thesis_csv(report);
  return {rows.at(n).begin(), rows.at(n).end()};
}

const Chart& chart(const std::vector<Chart>& charts, const std::string& id) {
  const auto it =
      std::find_if(charts.begin(), charts.end(), [&](const Chart& c) { return c.id == id; });
  if (it == charts.end()) throw std::runtime_error("no chart " + id);
  return *it;
}

TEST(ThesisTable, AMeasuredRowHasItsNumbersMachineAndProvenance) {
  auto cells = csv_row(known_report(), 1);
  EXPECT_EQ(cells["molecule"], "few");
  EXPECT_EQ(cells["engine"], "tuples-cpu");
  EXPECT_EQ(cells["cold_median_ms"], "10");
  EXPECT_EQ(cells["speed_up_over_cgal"], "4");
  EXPECT_EQ(cells["share_of_full_triangulation"], "0.25");
  EXPECT_EQ(cells["kernel1_ms"], "3");
  EXPECT_EQ(cells["memcpy_ms"], "") << "no such stage is no zero";
  EXPECT_EQ(cells["same_as_cgal"], "1");
  EXPECT_EQ(cells["hash"], "0000000000000abc");
  EXPECT_EQ(cells["beats_cgal_up_to_angstrom2"], "0");
  EXPECT_EQ(cells["loses_to_cgal_at_angstrom2"], "1");
  EXPECT_EQ(cells["cpu"], "Some CPU");
  EXPECT_EQ(cells["file"], "few, too.xyzr");
  EXPECT_EQ(cells["threads"], "2") << "0 is told as what it means";
}

TEST(ThesisTable, ACancelledRunSaysThatItIsIncomplete) {
  ThesisReport report = known_report();
  EXPECT_EQ(csv_row(report, 0)["run_complete"], "1");
  for (const Chart& c : thesis_charts(report)) {
    EXPECT_EQ(c.caption.find("Incomplete"), std::string::npos) << c.id;
  }
  report.complete = false;
  EXPECT_EQ(csv_row(report, 0)["run_complete"], "0");
  for (const Chart& c : thesis_charts(report)) {
    EXPECT_NE(c.caption.find("Incomplete"), std::string::npos) << c.id;
  }
}

TEST(ThesisTable, ASkippedRowHasItsReasonAndNoNumber) {
  auto cells = csv_row(known_report(), 3);
  EXPECT_EQ(cells["skipped"], "over 20 s");
  for (const char* name : {"runs", "cold_median_ms", "warm_median_ms", "speed_up_over_cgal",
                           "tetrahedra", "share_of_full_triangulation", "hash", "same_as_cgal"}) {
    EXPECT_EQ(cells.at(name), "") << name;
  }
}

TEST(ThesisTable, AllRowsHaveTheSameColumns) {
  const auto table = thesis_csv(known_report());
  ASSERT_EQ(table.size(), 4u);
  ASSERT_GT(table.front().size(), 20u);
  for (const auto& cells : table) {
    ASSERT_EQ(cells.size(), table.front().size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      EXPECT_EQ(cells[k].first, table.front()[k].first);
    }
  }
}

TEST(ThesisTable, BreakEvenInWords) {
  EXPECT_EQ(break_even_text({0, EngineChoice::cpu, 1.5, false, 1.75}), "1.5 Å² (lost at 1.75)");
  EXPECT_EQ(break_even_text({0, EngineChoice::cpu, 3.0, true, {}}), "≥ 3 Å²");
  EXPECT_EQ(break_even_text({0, EngineChoice::cpu, {}, false, 0.0}), "none of the tried alphas");
}

TEST(ThesisCharts, HaveTheThesisFiguresWithTheKnownNumbers) {
  const std::vector<Chart> charts = thesis_charts(known_report());
  EXPECT_EQ(chart(charts, "speed-up").series.at(0).values.at(0), 4);
  const ChartSeries& saved = chart(charts, "improvement-tuples-cpu").series.at(0);
  EXPECT_EQ(saved.values.at(0), 75);
  EXPECT_FALSE(saved.values.at(1)) << "skipped";
  EXPECT_EQ(chart(charts, "share-of-full-triangulation").series.at(0).values.at(0), 25);
  EXPECT_EQ(chart(charts, "ablation-tuples-cpu").series.at(0).values.at(0), 75);
  EXPECT_EQ(chart(charts, "beaten-up-to").series.at(0).notes.at(0), "0 Å² (lost at 1)");
  const Chart& stages = chart(charts, "stages-tuples-cpu");
  double sum = 0;
  for (const ChartSeries& s : stages.series) sum += s.values.at(0).value_or(0);
  EXPECT_DOUBLE_EQ(sum, 100);
  for (const Chart& c : charts) EXPECT_NE(c.caption.find("Some CPU, 2 threads"), std::string::npos);
  EXPECT_EQ(stages.categories, std::vector<std::string>{"few (12)"});
  ASSERT_EQ(stages.series.size(), 6u);
  for (const ChartSeries& s : stages.series) EXPECT_EQ(s.notes, std::vector<std::string>{""});
}

TEST(ThesisCharts, SayWhyARowWasSkipped) {
  ThesisReport report = known_report();
  report.rows[1].skipped = "over 20 s";
  const std::vector<Chart> charts = thesis_charts(report);
  for (const ChartSeries& s : chart(charts, "stages-tuples-cpu").series) {
    EXPECT_EQ(s.notes, std::vector<std::string>{"over 20 s"}) << s.name;
  }
}

}  // namespace
}  // namespace alphascope
