// A chart of lines with a cursor: tells at which sample the mouse is, and where it was clicked.
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
  const char* click = "";  // what a click does
};

// In all room that is left. A click or a drag: the place on the axis.
std::optional<double> draw_curve_plot(PanelContext& ctx, const CurvePlot& plot);

}  // namespace alphascope
