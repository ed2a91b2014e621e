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

  // Times of different tasks are not to be compared.
  bool comparable(const MeasuredRun& o) const {
    return alpha_angstrom2 == o.alpha_angstrom2 && tetrahedra_only == o.tetrahedra_only &&
           rebuilt == o.rebuilt && !same_threshold(o);
  }
  // Both only looked up in what was made of CGAL's triangulation: the same steps twice.
  bool same_threshold(const MeasuredRun& o) const {
    return rests_on_cgal && o.rests_on_cgal && !rebuilt && !o.rebuilt;
  }
};

// Cold: the first answer of an engine, set-up included. Warm: the latest of the later ones, as the
// slider asks for; what an engine prepares once in a while for the next ones is part of it.
struct ColdAndWarm {
  EngineInfo engine;
  std::optional<MeasuredRun> cold, warm;

  bool any() const { return cold || warm; }
  // Forgets what another engine took.
  void note(const AlphaComplex& complex, bool was_cold);
};

}  // namespace alphascope
