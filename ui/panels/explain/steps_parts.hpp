// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page “Steps”, for its own sources only.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alphascope {

struct BallSteps;
struct PanelContext;

// Draws the buttons First, Back, Play, Next and Last, and the choice of engine and optimisations.
void draw_steps_controls(PanelContext& ctx);

// Draws the list of steps. StepsState::shown must not be null. `width` is in pixels.
void draw_step_list(PanelContext& ctx, float width);
// Draws the meaning of the colours, and the numbers of the step.
void draw_step_counts(PanelContext& ctx, float width);

// Returns sentences that a user needs to understand the picture.
std::vector<std::string> steps_notes(const PanelContext& ctx);

// Returns the index of the step with this number, from 1, or this name, such as "filter"; none if
// there is no such step.
std::optional<std::size_t> step_number(const BallSteps& steps, const std::string& text);

}  // namespace alphascope
