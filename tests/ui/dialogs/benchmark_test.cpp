// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the benchmark page and the job behind it.
#include "app/viewer/jobs/benchmark.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

TEST(BenchmarkControlsText, AlphasAreNumbersBetweenCommasOrBlanks) {
  const std::vector<Alpha> fine = parse_alphas("1.000002652010249999");  // no double
  EXPECT_EQ(fine.at(0).digits(), "1.000002652010249999");
  EXPECT_EQ(parse_alphas("0, 1.4 -3;5"), (std::vector<Alpha>{0, 1.4, -3, 5}));
  for (const char* bad : {"", " , ", "1,x", "nan", "inf", "1e999"}) {
    EXPECT_THROW(parse_alphas(bad), std::invalid_argument) << bad;
  }
}

TEST(BenchmarkPage, OpensFromTheMenuAndAsksToRunCancelAndExport) {
  Panels panels({1280, 800, 1});
  panels.state = loaded_state();
  panels.state.gpu = GpuDevice{.why_not = "There is no NVIDIA driver."};
  panels.frame(2);
  panels.click("menu.Tools");
  panels.click("menu.benchmark.open");
  panels.frame(2);
  ASSERT_TRUE(panels.rects.contains("benchmark.run"));
  panels.click("benchmark.run");
  EXPECT_TRUE(panels.asked.run_benchmark);
  panels.click("benchmark.export");
  EXPECT_FALSE(panels.asked.export_benchmark) << "there is nothing yet";
  panels.state.benchmark.running = true;
  panels.frame(2);
  EXPECT_FALSE(panels.rects.contains("benchmark.run"));
  panels.click("benchmark.close");
  EXPECT_TRUE(panels.state.dialogs.show_benchmark) << "cancel first";
  panels.click("benchmark.cancel");
  EXPECT_TRUE(panels.asked.cancel_benchmark);
  panels.state.benchmark.running = false;
  panels.state.benchmark.can_export = true;
  panels.frame(2);
  panels.click("benchmark.export");
  EXPECT_TRUE(panels.asked.export_benchmark);
  panels.state.benchmark.exporting = true;
  panels.asked = {};
  panels.frame(2);
  panels.click("benchmark.run");
  panels.click("benchmark.export");
  EXPECT_FALSE(panels.asked.run_benchmark || panels.asked.export_benchmark);
  panels.click("benchmark.cancel");
  EXPECT_TRUE(panels.asked.cancel) << "the export";
  EXPECT_FALSE(panels.asked.cancel_benchmark);
  panels.click("benchmark.close");
  EXPECT_FALSE(panels.state.dialogs.show_benchmark);
}

TEST(BenchmarkPage, NotesFitBesideTheNumbersAtEverySize) {
  for (const Size size : {Size{1100, 700, 1}, {1280, 800, 1}, {1920, 1080, 1}, {1280, 800, 2}}) {
    Panels panels(size);
    BenchmarkInfo& b = panels.state.benchmark;
    b.columns = {
        "alpha (Å²)",     "engine",          "memcpy (ms)", "kernel I (ms)", "prefix sum (ms)",
        "kernel II (ms)", "kernel III (ms)", "other (ms)",  "cold (ms)",     "warm (ms)",
        "speed-up",       "tetrahedra",      "of full (%)", "same as CGAL",  "note"};
    std::vector<std::string> row(b.columns.size(), "0.0858");
    row[1] = "tuples-cpu, without alpha optimisation";
    row.back() = "NVIDIA GeForce RTX 4090; kernel I is I + II in one launch";
    b.rows = {row, row};
    b.differs = {false, false};
    panels.state.dialogs.show_benchmark = true;
    panels.frame(5);  // columns take their widths from the previous frame
    ASSERT_TRUE(panels.rects.contains("benchmark.note.1"));
    const WidgetRect note = panels.rects["benchmark.note.1"], all = panels.rects["benchmark.table"];
    EXPECT_LE(note.x1, all.x1) << size.width << " at " << size.scale;
    EXPECT_GT(note.x1 - note.x0, 60 * size.scale);
    EXPECT_GT(all.y1, note.y1);
  }
}

TEST_F(ViewerTest, TheBenchmarkMeasuresTheOpenMoleculeAndExportsIt) {
  viewer_->open(crambin());
  run("wait-idle\nclick menu.Tools\nclick menu.benchmark.open\n");
  BenchmarkSettings& c = viewer_->state().benchmark_settings;
  c.alphas = "0";
  c.runs = 1;
  c.folder = (folder_ / "out").string();
  run("click benchmark.run\nwait-idle\nclick benchmark.page.1\nframes 3\n");
  const BenchmarkInfo& b = viewer_->state().benchmark;
  EXPECT_EQ(b.error, "");
  EXPECT_TRUE(b.complete);
  EXPECT_FALSE(b.running);
  ASSERT_GE(b.rows.size(), 6u) << "CGAL, tuples, dual edges, three ablations";
  for (const auto& row : b.rows) EXPECT_EQ(row.size(), b.columns.size());
  for (const bool differs : b.differs) EXPECT_FALSE(differs);
  EXPECT_GE(b.charts.size(), 5u);
  run("click benchmark.export\nwait-idle\nframes 2\n");
  EXPECT_TRUE(fs::exists(folder_ / "out" / "thesis.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "speed-up.svg"));
  EXPECT_EQ(b.exported,
            "Wrote thesis.csv and " + std::to_string(b.charts.size()) + " figures to " + c.folder);
  EXPECT_FALSE(b.exporting);
  c.folder = (folder_ / "out" / "thesis.csv").string();
  run("click benchmark.export\nwait-idle\nframes 2\n");
  EXPECT_NE(b.error, "") << "a file is no folder";
  EXPECT_EQ(b.exported, "");
  EXPECT_EQ(viewer_->state().error, "") << "the page itself tells";
}

TEST_F(ViewerTest, ACancelledExportOfABenchmarkLeavesNoFile) {
  viewer_->open(crambin());
  run("wait-idle\nclick menu.Tools\nclick menu.benchmark.open\n");
  BenchmarkSettings& c = viewer_->state().benchmark_settings;
  c = {.alphas = "0", .engines = {}, .ablation = false, .runs = 1};
  c.folder = (folder_ / "out").string();
  run("click benchmark.run\nwait-idle\n");
  const BenchmarkInfo& b = viewer_->state().benchmark;
  ASSERT_TRUE(b.can_export) << b.error;
  viewer_->calls().jobs.export_benchmark();
  viewer_->calls().jobs.cancel(JobId::benchmark_files);  // before the worker is done
  run("wait-idle\nframes 2\n");
  EXPECT_FALSE(b.exporting);
  const bool written = fs::exists(folder_ / "out" / "thesis.csv");
  EXPECT_EQ(b.exported.empty(), !written);
  EXPECT_EQ(b.cancelled.find("was not written") != std::string::npos, !written) << b.cancelled;
  if (written) return;
  EXPECT_TRUE(!fs::exists(folder_ / "out") || fs::is_empty(folder_ / "out"));
}

TEST_F(ViewerTest, ACancelledBenchmarkKeepsWhatItHasAndABadAlphaIsTold) {
  viewer_->open(crambin());
  run("wait-idle\nclick menu.Tools\nclick menu.benchmark.open\n");
  BenchmarkSettings& c = viewer_->state().benchmark_settings;
  c.alphas = "zero";
  run("click benchmark.run\nframes 2\n");
  const BenchmarkInfo& b = viewer_->state().benchmark;
  EXPECT_NE(b.error.find("“zero”"), std::string::npos);
  c.alphas = "0, 1";
  c.runs = 1000;
  run("click benchmark.run\nframes 2\n");
  EXPECT_TRUE(b.running);
  run("click benchmark.cancel\nwait-idle\n");
  EXPECT_FALSE(b.running);
  EXPECT_FALSE(b.complete);
  EXPECT_EQ(b.error, "") << "to cancel is no error";
  EXPECT_NE(b.cancelled.find("Cancelled"), std::string::npos);
}

TEST_F(ViewerTest, WhatACancelledBenchmarkMeasuredCanBeExported) {
  viewer_->open(crambin());
  run("wait-idle\nclick menu.Tools\nclick menu.benchmark.open\n");
  BenchmarkSettings& c = viewer_->state().benchmark_settings;
  c.alphas = "0, 1, 2, 3, 4, 5, 6, 7, 8, 9";
  c.runs = 20;
  c.folder = (folder_ / "out").string();
  const BenchmarkInfo& b = viewer_->state().benchmark;
  run("click benchmark.run\n");
  for (int i = 0; i < 2000 && b.rows.empty(); ++i) {
    run("frames 1\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  run("click benchmark.cancel\nwait-idle\n");
  ASSERT_FALSE(b.rows.empty());
  EXPECT_FALSE(b.complete);
  run("click benchmark.export\nwait-idle\nframes 2\n");
  EXPECT_EQ(b.error, "");
  EXPECT_NE(b.exported.find("incomplete"), std::string::npos) << b.exported;
  const std::string csv = bytes("out/thesis.csv");
  EXPECT_NE(csv.find("run_complete"), std::string::npos);
  EXPECT_NE(csv.find(",,0,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace alphascope::testing
