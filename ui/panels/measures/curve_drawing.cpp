// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the plot of the curves, and takes the mouse on it.
#include <algorithm>
#include <cmath>

#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/measures/curves_plot.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/plot.hpp"

namespace alphascope {
namespace {

constexpr double kAlphaStep = 0.01;   // Å², as the slider's step
constexpr double kSolventStep = 0.1;  // Å, as the samples' step

void take_click(PanelContext& ctx, CurveAxis axis, double at) {
  ViewState& s = ctx.state;
  if (axis == CurveAxis::alpha) {
    s.go_to_alpha(std::round(at / kAlphaStep) * kAlphaStep);
  } else if (axis == CurveAxis::solvent) {
    const double steps = std::round(std::clamp(at, 0.0, kCurveSolventMostAngstrom) / kSolventStep);
    s.settings.request.solvent_radius_angstrom = steps / std::round(1 / kSolventStep);
  } else {
    const auto last = static_cast<double>(s.molecule.models.size()) - 1;
    s.settings.open.balls.model = static_cast<int>(std::lround(std::clamp(at, 0.0, last)));
    s.playback.models = false;
  }
}

}  // namespace

double shown_on_axis(const PanelContext& ctx, CurveAxis axis) {
  const Request& request = ctx.state.settings.request;
  if (axis == CurveAxis::alpha) return request.alpha_angstrom2;
  if (axis == CurveAxis::solvent) return request.solvent_radius_angstrom;
  return ctx.state.settings.open.balls.model;
}

void draw_curves_plot(PanelContext& ctx, const CurveState& memory) {
  const Plot plot = curves_plot(memory, shown_on_axis(ctx, memory.chart_axis));
  PlotMargins margins;
  if (plot.y.range.high >= 1e6) margins.left += 16;  // for "1,000,000"
  auto area = plot_area(ctx, margins);
  if (!area) return;
  draw_plot(ctx, plot, *area);
  const PlotMouse mouse = plot_mouse(ctx, *area, "curves.plot");
  const auto sample = nearest_point(plot.curves.front(), mouse.x);
  if (mouse.hovered && sample) {
    const double at = plot.curves.front().points[*sample].x;
    if (at >= area->x.low && at <= area->x.high) {
      draw_cursor(ctx, plot, *area, at);
      ImGui::SetTooltip("%s", curves_text(memory, *sample).c_str());
    }
  }
  if (mouse.held) take_click(ctx, memory.chart_axis, mouse.x);
}

}  // namespace alphascope
