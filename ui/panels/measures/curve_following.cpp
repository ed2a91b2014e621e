// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the curves and the chosen cavities, and makes the chart of them.
#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/chart/chart.hpp"
#include "core/chart/colour_map.hpp"
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

constexpr std::size_t kMostLines = kCavityColours;

// Makes the chart. `lines` is null for the totals.
void make_chart(CurveState& memory, const CavityCurves& curves, const CurveLinks* links,
                const CavityLines* lines, const std::vector<std::size_t>& rows) {
  memory.chart_axis = curves.axis;
  memory.colours.clear();
  if (!lines) {
    memory.chart = chart_of_totals(curves, curve_quantity(memory));
    memory.colours = {chart_colour(0), chart_colour(1)};
    return;
  }
  const CavityTable& table = *lines->table;
  std::vector<ChartedCavity> chosen;
  for (const std::size_t row : rows) {
    const Cavity& cavity = table.cavity(row);
    const char* kind = cavity.is_void() ? "void " : cavity.is_part() ? "part " : "pocket ";
    chosen.push_back({table.order[row], kind + std::to_string(row + 1)});
    // The colour is the same as in the view.
    memory.colours.push_back(cavity_colour(lines->numbers->of[table.order[row]]));
  }
  memory.chart = chart_of_cavities(curves, curve_quantity(memory), *links, chosen);
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
  std::shared_ptr<const CurveLinks> links;
  std::shared_ptr<const CavityLines> lines;
  std::vector<std::size_t> rows;
  if (!ctx.state.settings.selection.cavities.empty()) {
    // Cavities are followed even without curves. If a step of a slider were missed, their numbers
    // would be lost.
    const bool current = follow_cavities(ctx).current;
    CavityPage& page = *ctx.state.cavities.page;
    if (page.rows.lines) draw_layers_of_cavities(ctx, page, current);
    if (!current || !curves.ready()) return false;
    const auto linked = ctx.store.want(curve_links(curves.value, curves.have), ctx.inputs);
    if (!linked.ready()) return false;
    links = linked.value;
    lines = page.rows.lines;
    rows = page.selected_rows;
    if (rows.size() > kMostLines) rows.resize(kMostLines);
  }
  if (!curves.ready()) return false;
  const bool same = memory.curves == curves.value && memory.links == links && memory.rows == rows &&
                    memory.lines == lines && memory.chart_quantity == memory.quantity;
  if (same) return true;
  // The curve of a cavity that has left the table stays, since it shows where the cavity exists.
  const bool gone = lines && rows.empty() && !memory.rows.empty();
  if (gone && memory.curves == curves.value && memory.chart_quantity == memory.quantity)
    return true;
  make_chart(memory, *curves.value, links.get(), lines.get(), rows);
  memory.curves = curves.value;
  memory.links = links;
  memory.lines = lines;
  memory.rows = rows;
  memory.chart_quantity = memory.quantity;
  return true;
}

}  // namespace alphascope
