// SPDX-License-Identifier: GPL-3.0-or-later
// Times of one engine for one set of balls, with its set-up and without.
#pragma once

#include <optional>

#include "core/complex/engine_info.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {

struct AlphaComplex;

struct MeasuredRun {
  StageTimes times;
  double alpha_angstrom2 = 0;  // Å², of the computed complex
  bool tetrahedra_only = false;
  // In this run the engine made the filtration or complex from which it answers later alphas. Such
  // a run is not comparable with one that only takes a threshold.
  bool rebuilt = false;
  bool of_whole = false;  // EngineInfo::of_whole

  // Only times of the same task are comparable.
  bool comparable(const MeasuredRun& o) const {
    return alpha_angstrom2 == o.alpha_angstrom2 && tetrahedra_only == o.tetrahedra_only &&
           rebuilt == o.rebuilt && !same_threshold(o);
  }
  // Both runs only took a threshold of the filtration of all simplices. Their steps are the same,
  // so a comparison says nothing.
  bool same_threshold(const MeasuredRun& o) const {
    return of_whole && o.of_whole && !rebuilt && !o.rebuilt;
  }
};

// Cold: the first answer of an engine, set-up included. Warm: the latest of its later answers, as
// for a slider. A warm run includes work that the engine does now and then for its next answers.
struct ColdAndWarm {
  EngineInfo engine;
  std::optional<MeasuredRun> cold, warm;

  bool any() const { return cold || warm; }
  // Forgets the runs of another engine.
  void note(const AlphaComplex& complex, bool was_cold);
};

}  // namespace alphascope
