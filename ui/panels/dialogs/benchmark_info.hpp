// The benchmark page's data: what is to be measured, and what has been. Plain; the program fills
// it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/engine/engine_choice.hpp"

namespace alphascope {

// As the user types and ticks it; the program makes the suite's options of it when it starts.
struct BenchmarkControls {
  std::string alphas = "0, 1.4, 3";  // Å², as typed
  // Of those that can run here; CGAL is always measured.
  std::set<EngineChoice> engines = [] {
    const auto all = suite_engines();
    return std::set(all.begin(), all.end());
  }();
  bool ablation = true;
  int runs = 5, seconds_per_row = 10;
  std::string folder = "alphascope-benchmark";  // to export into
  bool charts = false;                          // shown instead of the table
};

struct BenchmarkInfo {
  bool running = false;
  std::string progress;  // "4hhb, α = 1.4 Å²"
  double share = 0;      // 0 to 1
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // grow while it runs
  std::vector<bool> differs;                   // the row's result is another than CGAL's
  std::vector<std::string> lines;              // machine; where CGAL overtakes
  std::vector<Chart> charts;
  bool complete = false;    // every row is there
  bool can_export = false;  // some are
  std::string cancelled;    // what became of a cancelled run
  std::string error;        // why it failed, or could not be exported
  std::string exported;     // where to
};

}  // namespace alphascope
