// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the chart of curves, of points of tables on screen, or of both together.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_curves.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/chart/colour_map.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kMostLines = kCavityColours;

CavityChart chart_of(const CurveState& memory, const CurveResults& now, bool has_whole) {
  const CurveQuantity quantity = curve_quantity(memory);
  CavityChart trace;
  if (now.trace) {
    trace = now.lines ? chart_of_trace(*now.trace, quantity, now.chosen)
                      : totals_of_trace(*now.trace, quantity);
  }
  if (!has_whole) return trace;
  CavityChart whole = memory.whole.chart;
  for (std::size_t k = 0; k < now.chosen.size(); ++k) {
    whole.chart.series[k].name = now.chosen[k].name;
  }
  // Curves are of whole networks, and points of parts if networks are split.
  const bool parts = now.trace && now.trace->question.split_networks;
  return parts ? whole : with_trace(whole, trace);
}

}  // namespace

std::vector<TracedSeries> series_of_rows(const CavityLines& lines, std::vector<std::size_t>& rows) {
  if (rows.size() > kMostLines) rows.resize(kMostLines);
  std::vector<TracedSeries> chosen;
  for (const std::size_t row : rows) {
    const Cavity& cavity = lines.table->cavity(row);
    const char* kind = cavity.is_void() ? "void " : cavity.is_part() ? "part " : "pocket ";
    chosen.push_back({lines.numbers->of[lines.table->order[row]], kind + std::to_string(row + 1)});
  }
  return chosen;
}

bool same_numbers(const std::vector<TracedSeries>& a, const std::vector<TracedSeries>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.number == y.number; });
}

bool follow_whole_chart(CurveState& memory, const CurveResults& now) {
  CurveState::Whole& whole = memory.whole;
  // Numbers that do not continue those of the last chart may be of other cavities.
  const bool goes_on = now.lines && memory.lines && now.lines->continues(*memory.lines);
  if (!goes_on) whole = {};
  if (!now.curves) return false;
  if (!now.lines) {
    whole = {chart_of_totals(*now.curves, curve_quantity(memory)), now.curves, {}, memory.quantity};
    return true;
  }
  if (now.links && now.rows.size() == now.chosen.size()) {
    std::vector<ChartedCavity> charted;
    for (std::size_t k = 0; k < now.rows.size(); ++k) {
      charted.push_back({now.lines->table->order[now.rows[k]], now.chosen[k].name});
    }
    whole = {chart_of_cavities(*now.curves, curve_quantity(memory), *now.links, charted),
             now.curves, now.chosen, memory.quantity};
    return true;
  }
  return whole.curves == now.curves && whole.quantity == memory.quantity &&
         same_numbers(whole.chosen, now.chosen);
}

void make_curves_chart(CurveState& memory, const CurveResults& now, bool has_whole) {
  memory.chart = chart_of(memory, now, has_whole);
  memory.colours.clear();
  if (!now.lines) memory.colours = {chart_colour(0), chart_colour(1)};
  // The colour of a cavity is the same as in the view.
  for (const TracedSeries& one : now.chosen) memory.colours.push_back(cavity_colour(one.number));
  memory.chart_axis = curve_axis(memory);
  memory.chart_quantity = memory.quantity;
  memory.curves = has_whole ? now.curves : nullptr;
  memory.links = now.links;
  memory.trace = now.trace;
  memory.lines = now.lines;
  memory.chosen = now.chosen;
}

}  // namespace alphascope
