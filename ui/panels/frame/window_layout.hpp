// The one call that draws the whole window for a frame. Includes no ImGui.
#pragma once

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widget_rects.hpp"

namespace alphascope {

class Store;
struct Inputs;

// All that the panels see and change.
struct WindowParts {
  ViewState& state;
  WidgetRects& rects;  // cleared and filled
  const Commands& commands;
  Store& store;          // of derived results
  const Inputs& inputs;  // that they are made of
  const Calls& calls;    // what the program is asked to do
  PanelSet& panels;
};

// Between ImGui's NewFrame and Render.
void draw_window(const WindowParts& parts, const PanelFonts& fonts, float scale);
// What lies over the picture that the view shows in this frame; after it is drawn.
void draw_over_picture(const WindowParts& parts, const PanelFonts& fonts, float scale);

}  // namespace alphascope
