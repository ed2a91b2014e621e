// Curves of cavities against alpha, solvent radius and model, as derived results.
#pragma once

#include <string>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/document/store/definition.hpp"

namespace alphascope {

// Where curves against alpha begin, Å².
inline constexpr double kCurveAlphaLeastAngstrom2 = -3;
// Of the balls on screen, whatever alpha is: from there to 10 Å² as the slider of alpha, and on in
// growing steps until the last cavity is filled. With exact volumes there are fewer samples.
const Definition<CavityCurves>& curves_over_alpha(CurveNumbers numbers = CurveNumbers::sums);

// Of the atoms on screen at their alpha, whatever the solvent radius is: from 0 to 5 Å.
const Definition<CavityCurves>& curves_over_solvent(CurveNumbers numbers = CurveNumbers::sums);
inline constexpr double kCurveSolventStepAngstrom = 0.1, kCurveSolventMostAngstrom = 5;

// Of the atoms on screen in every model, at their alpha and solvent radius, whichever model is on
// screen.
const Definition<CavityCurves>& curves_over_models(CurveNumbers numbers = CurveNumbers::sums);
// Why there can be none, as a sentence; empty: there can.
std::string why_no_model_curve(const Inputs& inputs);
// The index of the model on screen; there must be a model curve.
std::size_t shown_model(const BallReferences& atoms);

// The balls of another model, without solvent radius: those of the atoms at the same places in it,
// with the radii of the atoms on screen. Null where the atoms there have other names.
std::shared_ptr<const BallSet> balls_in_model(const BallReferences& atoms, std::size_t model);
// Another number for other atoms or radii, and the same in each model.
std::uint64_t key_of_frames(const BallReferences& atoms);

// Where the cavities on screen are on those curves. Of each curve another number in `curve`.
Definition<CurveLinks> curve_links(std::shared_ptr<const CavityCurves> curves, const Key& curve);

}  // namespace alphascope
