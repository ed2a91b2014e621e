// SPDX-License-Identifier: GPL-3.0-or-later
// Scale bar and legends over the 3-D view.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Draws scale bar and legends. `corner` and `size` of the view are in pixels. Returns the height of
// the legends above the view's bottom, pixels.
float draw_view_marks(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// Draws an outline of the text in the colour of the background, so that the text is legible on
// anything.
void draw_rim(const PanelContext& ctx, ImVec2 place, const std::string& text);

}  // namespace alphascope
