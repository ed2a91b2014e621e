// SPDX-License-Identifier: GPL-3.0-or-later
// The two calls that draw the window for a frame. Includes no ImGui.
#pragma once

#include "ui/widgets/widget_rects.hpp"

namespace alphascope {

class Commands;
class PanelSet;
class Store;
struct Calls;
struct Inputs;
struct PanelFonts;
struct ViewState;

// All that the panels see and change.
struct WindowParts {
  ViewState& state;
  WidgetRects& rects;  // cleared, then filled
  const Commands& commands;
  Store& store;          // makes derived results
  const Inputs& inputs;  // the present inputs of derived results
  const Calls& calls;    // calls to the program
  PanelSet& panels;
};

// Draws everything but labels over the picture. To be called between ImGui's NewFrame and Render.
void draw_window(const WindowParts& parts, const PanelFonts& fonts, float scale);
// Draws the labels over the view's picture. To be called after that picture is drawn, since labels
// belong to one view.
void draw_over_picture(const WindowParts& parts, const PanelFonts& fonts, float scale);

}  // namespace alphascope
