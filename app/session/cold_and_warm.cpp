// See the header.
#include "app/session/cold_and_warm.hpp"

namespace alphascope {

void ColdAndWarm::note(const AlphaComplex& complex, bool was_cold) {
  if (engine.name != complex.engine.name || engine.device != complex.engine.device) *this = {};
  engine = complex.engine;
  (was_cold ? cold : warm) =
      MeasuredRun{complex.timings, complex.alpha_angstrom2(), complex.tetrahedra_only};
}

}  // namespace alphascope
