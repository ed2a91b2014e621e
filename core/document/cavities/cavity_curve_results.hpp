// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of cavities against alpha, solvent radius and model, as derived results.
#pragma once

#include <string>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/document/store/definition.hpp"

namespace alphascope {

class BallReferences;

// First sample of curves against alpha, Å².
inline constexpr double kCurveAlphaLeastAngstrom2 = -3;
// Curves against alpha for the balls on screen; the present alpha does not matter. Samples go to 10
// Å² in even steps, like the alpha slider. Then steps grow until the last cavity is filled. With
// exact volumes there are fewer samples.
const Definition<CavityCurves>& curves_over_alpha(CurveNumbers numbers = CurveNumbers::sums);

// Curves against the solvent radius (0 to 5 Å) for the atoms on screen, at the present alpha.
const Definition<CavityCurves>& curves_over_solvent(CurveNumbers numbers = CurveNumbers::sums);
inline constexpr double kCurveSolventStepAngstrom = 0.1, kCurveSolventMostAngstrom = 5;

// Curves over all models for the atoms on screen, at the present alpha and solvent radius. They are
// the same whichever model is on screen.
const Definition<CavityCurves>& curves_over_models(CurveNumbers numbers = CurveNumbers::sums);
// The reason why there is no model curve, as a sentence; empty if there is one.
std::string why_no_model_curve(const Inputs& inputs);
// Index of the model on screen. Requires that there is a model curve.
std::size_t shown_model(const BallReferences& atoms);

// Balls of another model, without solvent radius: the same atoms at their positions in that model.
// Radii are those of the atoms on screen. Null if the models' atoms do not match, or coordinates
// exceed the lattice.
std::shared_ptr<const BallSet> balls_in_model(const BallReferences& atoms, std::size_t model);
// A number that depends on atoms and radii only, so it is the same for each model. 0: there is no
// model curve.
std::uint64_t key_of_frames(const BallReferences& atoms);

// Identifies the cavities on screen on a curve. `curve` must differ between curves.
Definition<CurveLinks> curve_links(std::shared_ptr<const CavityCurves> curves, const Key& curve);

}  // namespace alphascope
