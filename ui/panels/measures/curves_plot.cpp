// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the plot of curves and its texts from the chart.
#include "ui/panels/measures/curves_plot.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/chart/readable_number.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/widgets/plot.hpp"

namespace alphascope {
namespace {

const char* unit_of(CurveAxis axis) {
  return axis == CurveAxis::alpha ? "Å²" : axis == CurveAxis::solvent ? "Å" : "";
}

// The x range covers the present setting and all samples with a value other than 0. For models it
// covers all samples. The y range begins at 0.
void set_ranges(Plot& plot, CurveAxis axis, double shown) {
  PlotRange &x = plot.x.range, &y = plot.y.range;
  x.take(shown);
  y.take(0);
  for (const PlotCurve& curve : plot.curves) {
    for (const PlotCurve::Point& point : curve.points) {
      if (point.y) y.take(*point.y);
      const bool empty = !point.y || *point.y == 0;
      if (!empty || axis == CurveAxis::model) x.take(point.x);
    }
  }
  if (y.high <= y.low) y.high = y.low + 1;
  y.high += (y.high - y.low) * 0.04;
  const double margin = std::max((x.high - x.low) * 0.04, axis == CurveAxis::model ? 0.5 : 0.1);
  x.low -= margin;
  x.high += margin;
  if (axis == CurveAxis::solvent) x.low = std::max(x.low, 0.0);
}

// A dot at each value of a table that was on screen.
void add_traced_dots(Plot& plot, const CurveState& memory) {
  constexpr float kRadius = 2.6f;  // pixels at scale 1
  const std::vector<ChartSeries>& all = memory.chart.chart.series;
  for (std::size_t s = 0; s < all.size(); ++s) {
    for (std::size_t n = 0; n < memory.chart.traced.size(); ++n) {
      if (!memory.chart.traced[n] || !all[s].values[n]) continue;
      plot.dots.push_back(
          {all[s].x[n], *all[s].values[n], plot_colour(memory.colours[s]), kRadius});
    }
  }
}

}  // namespace

Plot curves_plot(const CurveState& memory, double shown) {
  const Chart& chart = memory.chart.chart;
  Plot plot;
  plot.x.label = chart.x_label;
  plot.y.label = chart.value_label;
  plot.y.whole = static_cast<CurveQuantity>(memory.chart_quantity) == CurveQuantity::mouths;
  const bool models = memory.chart_axis == CurveAxis::model;
  plot.x.whole = models;
  plot.x.offset = models ? 1 : 0;  // models are numbered from 1
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const ChartSeries& series = chart.series[s];
    PlotCurve curve{.name = series.name, .paint = plot_colour(memory.colours[s]), .dots = models};
    for (std::size_t n = 0; n < series.x.size(); ++n) {
      curve.points.push_back({series.x[n], series.values[n]});
    }
    plot.curves.push_back(std::move(curve));
  }
  add_traced_dots(plot, memory);
  for (const CurveMark& mark : memory.chart.marks) {
    const ChartSeries& series = chart.series[mark.series];
    plot.dots.push_back({series.x[mark.sample], *series.values[mark.sample],
                         plot_colour(memory.colours[mark.series]), 3.6f, true});
  }
  plot.lines.push_back({shown, plot_ink(ChartColourRole::accent), 1.5f});
  set_ranges(plot, memory.chart_axis, shown);
  // Points alone have the axis of the slider, which stays where it is while the hand moves.
  if (!memory.curves && !memory.chart.traced.empty()) {
    plot.x.range = {0, std::max(kCurveSolventMostAngstrom, shown)};
  }
  return plot;
}

std::string curves_text(const CurveState& memory, std::size_t sample) {
  const CurveAxis axis = memory.chart_axis;
  const std::vector<ChartSeries>& all = memory.chart.chart.series;
  const std::string unit = unit_of(axis),
                    value_unit = quantity_unit(static_cast<CurveQuantity>(memory.chart_quantity));
  std::string text = axis == CurveAxis::model ? "model " : "";
  text += axis_text(axis, all.front().x[sample]) + (unit.empty() ? "" : " " + unit);
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto& value = all[s].values[sample];
    text += "\n" + all[s].name + ": " +
            (!value               ? "none"
             : value_unit.empty() ? chart_number(*value)
                                  : chart_number(*value) + " " + value_unit);
    for (const CurveMark& mark : memory.chart.marks) {
      if (mark.series == s && mark.sample == sample) text += "\n    " + mark.text;
    }
  }
  return text + (axis == CurveAxis::alpha     ? "\nClick or drag to set alpha."
                 : axis == CurveAxis::solvent ? "\nClick or drag to set the solvent radius."
                                              : "\nClick to show this model.");
}

}  // namespace alphascope
