// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data of the benchmark page: the settings of a run, and its results so far.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/engine/engine_choice.hpp"

namespace alphascope {

// The settings as the user types and ticks them. The program turns them into the suite's options
// when a run starts.
struct BenchmarkSettings {
  std::string alphas = "0, 1.4, 3";  // Å², as typed
  // Engines to be measured, if they can run here. CGAL is always measured.
  std::set<EngineChoice> engines = [] {
    const auto all = suite_engines();
    return std::set(all.begin(), all.end());
  }();
  bool ablation = true;
  int runs = 5, seconds_per_row = 10;
  std::string folder = "alphascope-benchmark";  // folder to export into
  bool charts = false;                          // charts are shown instead of the table
};

struct BenchmarkInfo {
  bool running = false;
  bool exporting = false;  // table and figures are being written
  std::string progress;    // "4hhb, α = 1.4 Å²"
  double share = 0;        // 0 to 1
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // grow while it runs
  std::vector<bool> differs;                   // for each row: its result differs from CGAL's
  std::vector<std::string> lines;              // the machine, and where CGAL overtakes
  std::vector<Chart> charts;
  bool complete = false;    // every row is measured
  bool can_export = false;  // at least one row is measured
  std::string cancelled;    // a sentence on a cancelled run or export
  std::string error;        // why the run or the export failed
  std::string exported;     // names the folder of the exported files
};

}  // namespace alphascope
