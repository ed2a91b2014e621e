// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of an engine's step (core/explain/ball_steps.hpp) as layers of the view. No ImGui.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/explain/ball_steps.hpp"
#include "ui/layer.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// Returns the colour of a mark. Blue, orange and yellow (black on light ground) differ for every
// kind of colour vision (after Okabe and Ito). The ball itself has the colour of selected things.
Colour step_colour(StepMark mark, Theme theme);

struct StepScene {
  const BallSteps& steps;
  const Step& step;
  std::string ball_name;  // label of the ball
  std::shared_ptr<const BallSet> balls;
  Theme theme = Theme::dark;
};
// Makes a layer for each kind of mark. Balls are small spheres. Boxes and kept simplices are tubes,
// and dropped ones are thin lines. Triangles and tetrahedra that passed all tests are solid.
// Candidates overlap, so only their edges are drawn. The ball that drops most simplices has a
// label.
Layers make_steps_layers(const StepScene& scene, std::uint64_t key);

}  // namespace alphascope
