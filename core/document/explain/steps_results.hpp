// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball (core/explain/ball_steps.hpp) with their sentences, as a derived result.
// Also the ball and the engine to be shown.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/explain/steps_text.hpp"
#include "core/document/store/derived.hpp"
#include "core/explain/ball_saturation.hpp"

namespace alphascope {

class BallReferences;
struct Selection;

// An entry for each StepsEngine.
struct StepsEngineSpec {
  StepsEngine engine;
  const char* title;       // "Tuple engine (thesis)"
  bool has_optimisations;  // optimisations of TupleOptions that can be switched off
  BallSteps (*make)(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha_on_lattice,
                    const TupleOptions& options, const RunContext& context);
};
std::span<const StepsEngineSpec> steps_engines();
const StepsEngineSpec& spec_of(StepsEngine engine);

struct StepsRequest {
  BallIndex ball = 0;
  StepsEngine engine = StepsEngine::tuples;
  TupleOptions options = {};

  friend bool operator==(const StepsRequest&, const StepsRequest&) = default;
};

// The ball that a selection stands for: its first atom, or the first vertex of its first simplex.
struct SelectedBall {
  std::optional<BallIndex> ball;
  std::string why_not;  // a sentence; empty if there is a ball
};
SelectedBall selected_ball(const Selection& selection, const BallReferences& atoms);

// The ball whose centre is nearest to the mean of all centres; none if there are no balls.
std::optional<BallIndex> middle_ball(const BallSet& balls);

struct ExplainedSteps {
  BallSteps steps;
  std::vector<StepText> texts;  // one for each step
  BallSaturation saturation;    // does not depend on alpha
  std::string saturation_text;
  // If an optimisation is switched off: the same steps with all of them on.
  std::optional<BallSteps> optimised;
  // "4,495 instead of 39 4-tuples in kernel I, 4,495 instead of 12 in kernel II."; empty without
  // `optimised`.
  std::string growth;

  // The same count of the same step with all optimisations on; null if there is none.
  const StepCount* optimised_count(const Step& step, std::string_view id) const;
};

inline constexpr std::string_view kStepsId = "steps";  // id of the definition
// Makes the steps at the alpha of the inputs. Requires Inputs::atoms.
Definition<ExplainedSteps> explained_steps(const StepsRequest& asked);

}  // namespace alphascope
