// Scale bar and legends over the 3-D view.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// `corner` and `size` of the view, pixels. Returns how high the legends are, from its bottom.
float draw_view_marks(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// What is to be written there can be read on anything: its rim, in the colour of the background.
void draw_rim(const PanelContext& ctx, ImVec2 place, const std::string& text);

}  // namespace alphascope
