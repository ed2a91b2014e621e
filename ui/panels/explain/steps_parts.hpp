// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page “Steps”, for its own sources only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct BallSteps;
struct ExplainedSteps;
struct PanelContext;
template <class T>
struct Derived;

// Draws the buttons First, Back, Play, Next and Last, and the choice of engine and optimisations.
void draw_steps_controls(PanelContext& ctx);

// Draws the list of steps. StepsState::shown must not be null. `width` is in pixels.
void draw_step_list(PanelContext& ctx, float width);
// Draws the meaning of the colours, and the numbers of the step.
void draw_step_counts(PanelContext& ctx, float width);

// Draws the title, such as "Kernel II: 3 of 39 valid", the ball, the sentences, and how much more
// work there is.
void draw_step_text(PanelContext& ctx, float width);

// Returns sentences that a user needs to understand the picture.
std::vector<std::string> steps_notes(const PanelContext& ctx);

// Returns the index of the step with this number, from 1, or this name, such as "filter"; none if
// there is no such step.
std::optional<std::size_t> step_number(const BallSteps& steps, const std::string& text);

// Asks the store for the steps of this ball. If a job for an earlier question has run for long,
// cancels it.
Derived<ExplainedSteps> want_steps(PanelContext& ctx, BallIndex ball);
// Takes the steps, if they are ready. Goes to the step that was asked for meanwhile.
void take_steps(PanelContext& ctx, const Derived<ExplainedSteps>& found);

// Draws the present step in the view, if the user wants it. StepsState::shown must not be null.
void draw_step_in_view(PanelContext& ctx);
// Moves the view to the ball and its neighbours, if the user has asked for it.
void look_when_asked(PanelContext& ctx);

}  // namespace alphascope
