// A chart of lines with a cursor. It shows the values at the sample nearest to the mouse, and
// returns the position of a click.
#pragma once

#include <optional>
#include <string>

#include "core/document/cavities/cavity_chart.hpp"
#include "core/molecule/atom_colours.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

struct CurvePlot {
  const CavityChart* chart = nullptr;
  const std::vector<Rgb8>* colours = nullptr;  // of each series
  CurveAxis axis = CurveAxis::alpha;
  double shown = 0;        // the present setting
  std::string unit;        // of x: "Å"
  std::string value_unit;  // "Å³"
  const char* click = "";  // sentence on the effect of a click
};

// Draws the plot into all remaining room. Returns the position on the x axis of a click or drag.
std::optional<double> draw_curve_plot(PanelContext& ctx, const CurvePlot& plot);

}  // namespace alphascope
