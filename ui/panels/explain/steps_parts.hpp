// Parts of the page "Steps". For its sources only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/explain/ball_steps.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// First, back, play, next, last; engine and optimisations.
void draw_steps_controls(PanelContext& ctx);

// Of StepsMemory::shown, which must be there; width in pixels.
void draw_step_list(PanelContext& ctx, float width);
// What the colours mean, and the numbers of the step.
void draw_step_counts(PanelContext& ctx, float width);

// What else must be known to read the picture: sentences.
std::vector<std::string> steps_notes(const PanelContext& ctx);

// The index of a step that was named by its number, from 1, or by its name, such as "filter"; none:
// there is no such step.
std::optional<std::size_t> step_number(const BallSteps& steps, const std::string& text);

}  // namespace alphascope
