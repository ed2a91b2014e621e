// SPDX-License-Identifier: GPL-3.0-or-later
// Fills in the inputs of derived results on the command line.
#include "app/cli/derived_results.hpp"

#include <bit>
#include <memory>

#include "app/session/gpu_engines.hpp"
#include "app/session/system_memory.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope::cli {

Inputs derived_inputs(const Input& input, double solvent_radius_angstrom,
                      const Alpha& alpha_angstrom2) {
  Inputs inputs;
  inputs.balls = input.opened.prepared->balls;
  if (solvent_radius_angstrom != 0) {
    inputs.balls =
        std::make_shared<const BallSet>(with_solvent(*inputs.balls, solvent_radius_angstrom));
  }
  inputs.balls_key = std::bit_cast<std::uint64_t>(solvent_radius_angstrom + 0.0) + 1;
  inputs.body_key = 1;
  inputs.solvent_radius_angstrom = solvent_radius_angstrom;
  inputs.atoms =
      std::make_shared<const BallReferences>(input.opened.molecule, input.opened.prepared);
  inputs.alpha_angstrom2 = alpha_angstrom2;
  // A GPU's first triangulation begins some 0.5 s after it was asked for. Two threads take 1 s for
  // this many balls.
  constexpr std::size_t kWorthAStart = 500'000;
  if (inputs.balls->size() >= kWorthAStart) {
    inputs.triangulation_maker = GpuEngines::of_program().triangulations();
  }
  return inputs;
}

Evaluator make_evaluator() {
  return Evaluator(
      [] { return available_bytes().value_or(std::numeric_limits<std::uint64_t>::max()); });
}

}  // namespace alphascope::cli
