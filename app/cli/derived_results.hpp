// Derived results on the command line: the same definitions as the window's, made at once.
#pragma once

#include <limits>

#include "app/cli/input.hpp"
#include "core/document/store/evaluator.hpp"

namespace alphascope::cli {

inline constexpr double kNoAlpha = std::numeric_limits<double>::quiet_NaN();

// The balls of the input grown by the solvent radius, and their atoms. An evaluator may be asked
// with several solvent radii and alphas of one input.
Inputs derived_inputs(const Input& input, double solvent_radius_angstrom,
                      const Alpha& alpha_angstrom2 = kNoAlpha);

// Its results may take all memory that the system still has.
Evaluator make_evaluator();

}  // namespace alphascope::cli
