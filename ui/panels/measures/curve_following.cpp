// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the curves, the points of tables on screen, and the chosen cavities.
#include <memory>

#include "core/cavity_identity/cavity_trace.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// The points of the tables so far, if they are of the atoms, the alpha and the choices on screen.
std::shared_ptr<const CavityTrace> trace_on_screen(const PanelContext& ctx,
                                                   const CurveState& memory) {
  const auto& page = ctx.state.cavities.page;
  const bool has_them = curve_axis(memory) == CurveAxis::solvent &&
                        numbers_for(curve_quantity(memory)) == CurveNumbers::sums;
  if (!has_them || !page || !page->rows.lines) return nullptr;
  return page->rows.lines->is_of_but_for_radius(ctx.inputs) ? page->rows.lines->trace : nullptr;
}

void follow_chosen(PanelContext& ctx, const CurveState& memory, const Derived<CavityCurves>& curves,
                   CurveResults& now) {
  // Cavities are followed even without curves. If a step of a slider were missed, their numbers
  // would be lost.
  const bool current = follow_cavities(ctx).current;
  CavityPage& page = *ctx.state.cavities.page;
  if (!page.rows.lines) return;
  draw_layers_of_cavities(ctx, page, current);
  now.lines = page.rows.lines;
  now.rows = page.selected_rows;
  now.chosen = series_of_rows(*now.lines, now.rows);
  // The curve of a cavity that has left the table stays, since it shows where the cavity exists.
  const bool goes_on = memory.lines && now.lines->continues(*memory.lines);
  if (now.rows.empty() && goes_on) now.chosen = memory.chosen;
  now.links_follow = curves.ready() && !current;
  if (!current || !curves.ready()) return;
  const auto linked = ctx.store.want(curve_links(curves.value, curves.have), ctx.inputs);
  now.links_follow = is_on_its_way(linked.state);
  if (linked.ready()) now.links = linked.value;
}

}  // namespace

CurveAxis curve_axis(const CurveState& memory) {
  return static_cast<CurveAxis>(memory.axis);
}

CurveQuantity curve_quantity(const CurveState& memory) {
  return static_cast<CurveQuantity>(memory.quantity);
}

const Definition<CavityCurves>& curves_wanted(const CurveState& memory) {
  const CurveNumbers numbers = numbers_for(curve_quantity(memory));
  const CurveAxis axis = curve_axis(memory);
  return axis == CurveAxis::alpha     ? curves_over_alpha(numbers)
         : axis == CurveAxis::solvent ? curves_over_solvent(numbers)
                                      : curves_over_models(numbers);
}

bool follow_curves(PanelContext& ctx, CurveState& memory, const Derived<CavityCurves>& curves) {
  const bool chosen = !ctx.state.settings.selection.cavities.empty();
  const bool traces = curve_axis(memory) == CurveAxis::solvent;
  CurveResults now;
  if (curves.ready()) now.curves = curves.value;
  if (chosen) {
    follow_chosen(ctx, memory, curves, now);
    if (!now.lines) return false;
  } else if (traces && !now.curves) {
    follow_cavities(ctx);
  }
  now.trace = trace_on_screen(ctx, memory);
  const bool same =
      memory.curves == now.curves && memory.links == now.links && memory.trace == now.trace &&
      memory.lines == now.lines && memory.chart_axis == curve_axis(memory) &&
      memory.chart_quantity == memory.quantity && same_numbers(memory.chosen, now.chosen);
  if (same) return now.trace || now.curves;
  const bool has_whole = follow_whole_chart(memory, now);
  if (!has_whole) {
    if (!now.trace || now.links_follow) return false;
    // A single point is no curve: it does not replace one while another is on its way.
    const bool old = !memory.chart.chart.empty() && memory.chart_axis == curve_axis(memory);
    const bool single = now.trace->points.size() == 1;
    if (single && old && is_on_its_way(curves.state)) return false;
  }
  make_curves_chart(memory, now, has_whole);
  return true;
}

}  // namespace alphascope
