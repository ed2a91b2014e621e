// SPDX-License-Identifier: GPL-3.0-or-later
// The page of curves: cavities against alpha, solvent radius or model. It plots the chosen
// cavities, or the totals of voids and pockets.
#include <algorithm>
#include <cmath>

#include "core/chart/chart.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/measures/lives_view.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

void legend(PanelContext& ctx, const CurveState& memory) {
  const std::vector<ChartSeries>& series = memory.chart.chart.series;
  for (std::size_t s = 0; s < series.size(); ++s) {
    legend_entry(ctx, memory.colours[s], series[s].name);
  }
  if (!memory.chart.marks.empty()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "ring: splits or joins");
  }
  if (!memory.chart.traced.empty()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "dot: from the table");
  }
  record(ctx, "curves.legend");
}

void choices(PanelContext& ctx, CurveState& memory) {
  // Pixels at scale 1, of all choices; the names of the pages stand before them.
  constexpr float kWidth = 632, kAxes = 240;
  if (ImGui::GetContentRegionAvail().x < ctx.px(kWidth)) ImGui::NewLine();
  choice(ctx, "curves.quantity", {"Volume", "Area", "Exact", "Mouths", "Lives"}, memory.quantity,
         ctx.px(312));
  tooltip(ctx,
          "SA volume and SA area: CASTp's sums for the region of probe centres. Exact: the "
          "volume of the cavity's tetrahedra outside all grown balls, about twenty times "
          "slower. Mouths: their number. Lives: the range of alpha in which each cavity exists.");
  if (memory.quantity == CurveState::kLives) {
    ImGui::SameLine(0, ctx.px(10));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "against alpha");
    return;
  }
  const float gap = ctx.px(8);
  same_line_where_it_fits(ImGui::CalcTextSize("against").x + gap + ctx.px(kAxes), ctx.px(10));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "against");
  ImGui::SameLine(0, gap);
  choice(ctx, "curves.axis", {"Alpha", "Solvent", "Model"}, memory.axis, ctx.px(kAxes));
}

std::string nothing_text(const PanelContext& ctx) {
  return ctx.state.settings.selection.cavities.empty()
             ? "There are no cavities here to plot."
             : "The selected cavities do not exist at this alpha and solvent radius. Select "
               "others on the page Cavities.";
}

void draw_curves(PanelContext& ctx, CurveState& memory) {
  choices(ctx, memory);
  reset_for_molecule(memory, ctx.state.file_hash(), [](const CurveState& old) {
    CurveState fresh;
    fresh.axis = old.axis;
    fresh.quantity = old.quantity;
    return fresh;
  });
  if (memory.quantity == CurveState::kLives) return draw_cavity_lives(ctx, memory.lives);
  const CurveAxis axis = curve_axis(memory);
  // Between two pictures the atoms of the balls are unknown.
  const bool unknown = !ctx.inputs.atoms;
  const bool none = !unknown && axis == CurveAxis::model && !why_no_model_curve(ctx.inputs).empty();
  const bool asked = unknown || none || curves_are_asked_for(ctx, memory);
  // Points of the solvent radius appear unasked, since they are of tables that are there.
  if (!asked && axis != CurveAxis::solvent) return;
  const bool wanted = asked && !unknown && !none;
  const Derived<CavityCurves> curves =
      wanted ? ctx.store.want(curves_wanted(memory), ctx.inputs) : Derived<CavityCurves>{};
  const bool current = follow_curves(ctx, memory, curves);
  const bool old = memory.chart_quantity >= 0 && memory.chart_axis == axis && !none;
  if (!current && !old) {
    if (!asked) return;
    muted_wrapped(ctx, curves_waiting_text(ctx, memory, curves));
    record(ctx, "curves.waiting");
    curves_cancel_button(ctx, memory, curves);
    return;
  }
  if (memory.chart.chart.empty()) {
    muted_wrapped(ctx, nothing_text(ctx));
    record(ctx, "curves.nothing");
    return;
  }
  curves_save_buttons(ctx, memory, current);
  // Curves that do not belong to the picture are grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  legend(ctx, memory);
  ImGui::PopStyleVar();
  if (asked && !curves.ready()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, curves_waiting_text(ctx, memory, curves));
    ImGui::SameLine(0, ctx.px(8));
    curves_cancel_button(ctx, memory, curves);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  ImGui::PushFont(ctx.fonts.small);
  draw_curves_plot(ctx, memory);
  ImGui::PopFont();
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> curves_panel() {
  return panel_of(draw_curves);
}

}  // namespace alphascope
