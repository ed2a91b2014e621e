// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `bench`. Another source runs --suite thesis.
#pragma once

#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope::cli {

struct BenchOptions {
  InputOptions input;
  std::vector<std::string> files;
  Request request;
  std::vector<Alpha> alphas;  // Å²
  std::vector<int> threads{1};
  int runs = 5;
  std::string csv;
  // The following options belong to --suite thesis.
  std::string suite;                 // "thesis", or empty
  std::vector<std::string> engines;  // ids; empty: all engines that can run here
  double seconds_per_row = 20;
  bool ablation = true;
  std::string rounds, json, charts;  // charts: path of a folder
};

ExitCode run_thesis_bench(const BenchOptions& options);

}  // namespace alphascope::cli
