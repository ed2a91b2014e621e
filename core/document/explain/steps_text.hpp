// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball (core/explain/ball_steps.hpp) in sentences, for readers who want to know
// how the algorithm works. For window and command line.
#pragma once

#include <string>
#include <vector>

#include "core/document/explain/explanation_text.hpp"
#include "core/explain/ball_steps.hpp"

namespace alphascope {

struct StepText {
  std::string title;  // "Kernel II"
  std::string brief;  // the main number, for a list: "41 of 210 left"
  std::string text;   // some sentences
};
StepText step_text(const BallSteps& steps, const Step& step, const BallName& name);

// Ids as in JSON: "dual_edges", "pairs".
const char* steps_engine_id(StepsEngine engine);
const char* step_id(StepKind kind);

}  // namespace alphascope
