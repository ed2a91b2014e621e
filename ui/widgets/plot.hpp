// SPDX-License-Identifier: GPL-3.0-or-later
// Plots and charts in the window, and the mouse over them. core/chart has their data and layout.
#pragma once

#include <optional>
#include <string>

#include "core/chart/plot.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

struct Rgb8;

// A colour of our own on a plot.
ChartPaint plot_colour(const Rgb8& colour, float opacity = 1);
ChartPaint plot_colour(const Colour& colour, float opacity = 1);
inline ChartPaint plot_ink(ChartColourRole ink, float opacity = 1) {
  return {ink, {}, opacity};
}

// Measures text in ImGui's present font, at the window's scale.
ChartFont chart_type(const PanelContext& ctx);

// Draws a drawing at `origin`. Returns the tooltip of the box or dot under the mouse; empty: none.
std::string draw_drawing(PanelContext& ctx, const ChartDrawing& drawing, ImVec2 origin);

// Lengths around a plot in pixels at scale 1.
struct PlotMargins {
  float left = 56, top = 2, right = 16, bottom = 6;
  float lines_above = 0, lines_below = 2;  // lines of text, beside `top` and `bottom`
  float least_width = 120, least_height = 40;
};
// Returns the remaining room inside the margins; none if there is too little.
std::optional<PlotArea> plot_area(const PanelContext& ctx, const PlotMargins& margins);

// Sets the area's ranges to those of the plot, and draws the plot there.
void draw_plot(PanelContext& ctx, const Plot& plot, PlotArea& area);

// The mouse over a plot.
struct PlotMouse {
  bool hovered = false;
  bool held = false;     // its button was pressed on the plot, and is still down
  bool dragged = false;  // it has moved since then
  bool clicked = false;  // released without a drag
  double x = 0, y = 0;   // its place, within the ranges of the plot
};
// Makes the area an item of this name. The item is the last one then.
PlotMouse plot_mouse(PanelContext& ctx, const PlotArea& area, const char* name);

// A vertical line at `x` under the mouse, and a dot on each curve that has a point there.
void draw_cursor(PanelContext& ctx, const Plot& plot, const PlotArea& area, double x);

// A square of this colour and a name in the present line, as part of a legend above a plot.
void legend_entry(PanelContext& ctx, const Rgb8& colour, const std::string& name);

}  // namespace alphascope
