// The one call that draws the whole window for a frame. Includes no ImGui.
#pragma once

#include "core/document/commands.hpp"
#include "ui/panels/style.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/widget_rects.hpp"

namespace alphascope {

// Between ImGui's NewFrame and Render. `rects` is cleared and filled. The commands act on `state`.
void draw_window(ViewState& state, WidgetRects& rects, const Commands& commands,
                 const PanelFonts& fonts, float scale);

}  // namespace alphascope
