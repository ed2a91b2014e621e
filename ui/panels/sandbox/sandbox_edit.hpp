// Changes of the sandbox, for its page, its drawing and its commands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/molecule/sandbox.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// Why the balls on screen cannot be changed by hand; empty: they can, or are already.
std::string why_not_by_hand(const ViewState& state);
// From the balls on screen; nothing happens when there is a sandbox, or none can be.
void start_sandbox(ViewState& state);

// Of the sandbox, by index, ascending: selected themselves, or corners of what is.
std::vector<BallIndex> chosen_balls(const ViewState& state);
void choose_ball(ViewState& state, std::size_t ball, bool more = false);
void remove_chosen(ViewState& state);

// A multiple of the step, without minus zero; `step` 0: as it is.
double snapped(double angstrom, double step);

// The flat drawing is in the view's place.
bool shows_flat_drawing(const ViewState& state);

}  // namespace alphascope
