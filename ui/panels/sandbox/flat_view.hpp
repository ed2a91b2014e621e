// SPDX-License-Identifier: GPL-3.0-or-later
// The flat drawing of balls in a plane, which replaces the 3-D picture and in which balls can be
// changed.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Draws it, and takes the mouse within the rectangle.
void draw_flat_view(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// Returns the scale of the last drawing; 0: there was none.
double flat_angstrom_per_pixel(const ViewState& state);

}  // namespace alphascope
