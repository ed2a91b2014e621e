// SPDX-License-Identifier: GPL-3.0-or-later
// Derived results on the command line. They have the same definitions as in the window, and are
// evaluated at once.
#pragma once

#include <limits>

#include "app/cli/input.hpp"
#include "core/document/store/evaluator.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope::cli {

inline constexpr double kNoAlpha = std::numeric_limits<double>::quiet_NaN();

// Inputs with the molecule's atoms and its balls, grown by the solvent radius. One evaluator takes
// inputs with several solvent radii and alphas of the same molecule.
Inputs derived_inputs(const Input& input, double solvent_radius_angstrom,
                      const Alpha& alpha_angstrom2 = kNoAlpha);

// Its results may take all memory that is free.
Evaluator make_evaluator();

}  // namespace alphascope::cli
