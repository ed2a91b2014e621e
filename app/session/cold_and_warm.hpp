// Times of one engine at one set of balls: with its set-up, and without.
#pragma once

#include <optional>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

struct MeasuredRun {
  StageTimes times;
  double alpha_angstrom2 = 0;  // what was computed
  bool tetrahedra_only = false;
  // The engine made anew what it answers later alphas from; such a run is not to be compared with
  // one that only looked there.
  bool rebuilt = false;
  bool rests_on_cgal = false;  // as EngineInfo has it
};

// Cold: the first answer of an engine, set-up included. Warm: the latest of the later ones, as the
// slider asks for; what an engine prepares once in a while for the next ones is part of it.
struct ColdAndWarm {
  EngineInfo engine;
  std::optional<MeasuredRun> cold, warm;

  // Forgets what another engine took.
  void note(const AlphaComplex& complex, bool was_cold);
};

}  // namespace alphascope
