// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of single settings of the display: check boxes and sliders as the table of settings
// (display_fields.hpp) describes them. A panel only decides their order.
#pragma once

#include <string>

#include "core/document/settings/display_fields.hpp"

namespace alphascope {

struct PanelContext;

// The name of the control: "display.ball_scale".
std::string control_name(const DisplayField& field);

// Draws a check box, or a label and a slider, for a switch or a number, with its explanation.
void display_row(PanelContext& ctx, const DisplayField& field);
void display_row(PanelContext& ctx, DisplayField::Member member);

// The opacity in the picture of balls, simplices or an object whose setting is `set`: less while a
// page fades them.
double shown_opacity(const PanelContext& ctx, double set);
// Draws a line that says how far a page fades them, and why.
void fading_note(PanelContext& ctx, const std::string& name);

// Draws the slider of a number under another name, without its label.
void display_slider(PanelContext& ctx, const DisplayField& field, const char* name);

}  // namespace alphascope
