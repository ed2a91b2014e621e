// What is drawn of a step of an engine (core/explain/ball_steps.hpp). No ImGui.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/explain/ball_steps.hpp"
#include "ui/layer.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// Blue, orange and yellow (black on light ground) differ for every kind of colour vision (after
// Okabe and Ito); the ball itself is in the colour of what is selected.
Colour step_colour(StepMark mark, Theme theme);

struct StepScene {
  const BallSteps& steps;
  const Step& step;
  std::string ball_name;  // written at the ball
  std::shared_ptr<const BallSet> balls;
  Theme theme = Theme::dark;
};
// A layer for each kind of mark: balls as small spheres; boxes and what is kept as tubes; what is
// dropped as thin lines. Triangles and tetrahedra that passed the tests are bodies; candidates
// overlap and are drawn by their edges. The ball that ends most tests has a name, too.
Layers make_steps_layers(const StepScene& scene, std::uint64_t key);

}  // namespace alphascope
