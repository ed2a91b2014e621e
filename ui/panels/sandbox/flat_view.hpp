// The flat drawing of balls in a plane, in the place of the 3-D picture: to look at and to change.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Takes the mouse within the rectangle.
void draw_flat_view(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// Of the drawing as it was drawn last; 0: never.
double flat_angstrom_per_pixel(const ViewState& state);

}  // namespace alphascope
