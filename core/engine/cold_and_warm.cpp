// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a cold run from a warm one, by the stages and the route that an answer reports.
#include "core/engine/cold_and_warm.hpp"

#include <algorithm>

#include "core/engine/engine.hpp"

namespace alphascope {

namespace {

bool rebuilt(const AlphaComplex& complex) {
  const auto& stages = complex.timings.stages;
  return std::any_of(stages.begin(), stages.end(), [](const StageTime& s) { return s.setup; }) ||
         (!complex.tetrahedra_only && complex.engine.route == kClippingRoute);
}

}  // namespace

void ColdAndWarm::note(const AlphaComplex& complex, bool was_cold) {
  if (engine.name != complex.engine.name || engine.device != complex.engine.device) *this = {};
  engine = complex.engine;
  (was_cold ? cold : warm) =
      MeasuredRun{complex.timings, complex.alpha_angstrom2(), complex.tetrahedra_only,
                  rebuilt(complex), complex.engine.of_whole};
}

}  // namespace alphascope
