// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the sandbox, which its page, its drawing and its commands share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct ViewState;

// Says why the balls on screen cannot be changed by hand; empty if they can, or are a sandbox
// already.
std::string why_not_editable(const ViewState& state);
// Makes a sandbox of the balls on screen. Nothing happens if there is one already, or none can be
// made.
void start_sandbox(ViewState& state);

// Returns indices of balls in the sandbox, ascending: selected balls, and corners of selected
// simplices.
std::vector<BallIndex> selected_balls(const ViewState& state);
void select_ball(ViewState& state, std::size_t ball, bool more = false);
void remove_selected_balls(ViewState& state);

// Returns the nearest multiple of the step, without minus zero. `step` 0 changes nothing.
double snapped(double angstrom, double step);

// Whether the flat drawing replaces the 3-D picture.
bool shows_flat_drawing(const ViewState& state);

}  // namespace alphascope
