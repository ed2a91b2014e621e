// Runs engines in turns on one molecule at one alpha, each within its own time, and takes medians.
// What is measured and why is thesis_suite.hpp's business.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/session/engines.hpp"

namespace alphascope {

double median(std::vector<double> values);  // of at least one

struct Contestant {
  EngineChoice choice = EngineChoice::cpu;
  EngineSettings settings;
  std::string skipped;  // set: does not run, or did not finish once; why

  // Of the counted runs: the first is not, unless it is the only one that fitted the time.
  std::vector<double> cold, warm;  // ms
  std::vector<std::vector<StageTime>> cold_stages;
  EngineInfo engine;
  std::size_t tetrahedra = 0;
  std::uint64_t hash = 0;
  bool hashes_agree = true;  // of all its runs
  bool too_slow = false;     // skipped for lack of time

  bool measured() const { return !cold.empty(); }
  // Median of each stage, in the order of the engine's first run; 0 where a run had none.
  std::vector<StageTime> stage_medians() const;
};

struct ContestRules {
  std::shared_ptr<const BallSet> balls;
  AlphaRequest request;
  int repeats = 5;      // counted runs
  double seconds = 20;  // for all runs of one contestant
};

// Throws Cancelled when `cancel` says so. A contestant that throws anything else is skipped, with
// its message.
void run_contest(std::vector<Contestant>& contestants, const ContestRules& rules,
                 const EngineFactory& factory, const CancelToken& cancel);

}  // namespace alphascope
