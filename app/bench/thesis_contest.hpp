// SPDX-License-Identifier: GPL-3.0-or-later
// Runs engines in turns on one molecule at one alpha, each within its own time limit, and takes
// medians. The caller, thesis_suite.hpp, chooses engines, molecules and alphas.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/session/engines.hpp"

namespace alphascope {

class CancelToken;

double median(std::vector<double> values);  // `values` must not be empty

struct Contestant {
  EngineChoice choice = EngineChoice::cpu;
  EngineSettings settings;
  std::string skipped;  // why the contestant does not run or did not finish; empty: it runs

  // Times of the counted runs. The first run is not counted, unless no other fitted into the time.
  std::vector<double> cold, warm;  // ms
  std::vector<std::vector<StageTime>> cold_stages;
  EngineInfo engine;
  std::size_t tetrahedra = 0;
  std::uint64_t hash = 0;
  bool hashes_agree = true;  // over all its runs
  bool too_slow = false;     // skipped because its time was over

  bool measured() const { return !cold.empty(); }
  // The median of each stage, in the order of the engine's first run. A run without the stage
  // counts as 0.
  std::vector<StageTime> stage_medians() const;
};

struct ContestRules {
  std::shared_ptr<const BallSet> balls;
  AlphaRequest request;
  int repeats = 5;      // counted runs
  double seconds = 20;  // limit for all runs of one contestant
};

// Throws Cancelled when `cancel` is cancelled. A contestant that throws another exception is
// skipped with its message.
void run_contest(std::vector<Contestant>& contestants, const ContestRules& rules,
                 const EngineFactory& factory, const CancelToken& cancel);

}  // namespace alphascope
