// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out the bars of cavities, one below the other. Alpha is the x axis.
#include "ui/panels/measures/lives_plot.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/measures/lives_parts.hpp"
#include "ui/panels/measures/lives_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr float kLeastRow = 5, kMostRow = 14;  // pixels at scale 1, height of a bar

void add_bar(BarsPlot& bars, const CavityBar& bar, std::size_t k, const ChartPaint& paint) {
  const double middle = static_cast<double>(k) + 0.5;
  const double least = 0.5 / static_cast<double>(bars.row());  // half a pixel
  const PlotRange& alpha = bars.plot.x.range;
  const auto part = [&](double from, double to, double share) {
    const double half = std::max(share / 2, least);
    bars.plot.boxes.push_back(
        {std::max(from, alpha.low), std::min(to, alpha.high), middle - half, middle + half, paint});
  };
  const double closed = std::clamp(bar.closed_angstrom2, bar.born_angstrom2, bar.gone_angstrom2);
  if (bar.born_angstrom2 < closed) part(bar.born_angstrom2, closed, 0.3);
  if (bar.is_ever_void()) part(closed, bar.gone_angstrom2, 0.8);
}

}  // namespace

std::optional<std::size_t> BarsPlot::bar_at(const std::vector<CavityBar>& bars,
                                            const PlotMouse& at) const {
  const double n = std::floor(at.y);
  if (n < 0 || n >= static_cast<double>(drawn)) return {};
  const auto bar = static_cast<std::size_t>(n);
  // Half a row of slack makes short bars easier to hit.
  const double slack = area.x_at(area.left + row() / 2) - area.x.low;
  const bool hit =
      at.x >= bars[bar].born_angstrom2 - slack && at.x <= bars[bar].gone_angstrom2 + slack;
  return hit ? std::optional(bar) : std::nullopt;
}

std::optional<BarsPlot> place_bars(const PanelContext& ctx, const ShownLives& memory,
                                   double shown) {
  const auto area = plot_area(ctx, {.left = 16, .least_height = 30});
  if (!area) return {};
  BarsPlot bars{.area = *area};
  const auto fit = static_cast<std::size_t>(area->height() / ctx.px(kLeastRow));
  bars.drawn = std::min(fit, memory.bars.longest.size());
  if (bars.drawn == 0) return {};
  const float row = std::min(area->height() / static_cast<float>(bars.drawn), ctx.px(kMostRow));
  bars.plot.x = {.range = {memory.from_angstrom2, shown}, .label = axis_label(CurveAxis::alpha)};
  for (std::size_t k = 0; k < bars.drawn; ++k) {
    bars.plot.x.range.take(memory.bars.longest[k].gone_angstrom2);
  }
  PlotRange& alpha = bars.plot.x.range;
  alpha.high += 0.04 * (alpha.high - alpha.low);
  bars.plot.y = {.range = {static_cast<double>(area->height() / row), 0}, .numbered = false};
  bars.area.x = alpha;
  bars.area.y = bars.plot.y.range;
  return bars;
}

void add_bars(PanelContext& ctx, BarsPlot& bars, const ShownLives& memory, const CavityPage& page) {
  const PlotArea& area = bars.area;
  const double edge = area.x_at(area.left + ctx.px(2)) - area.x.low;
  for (std::size_t k = 0; k < bars.drawn; ++k) {
    const CavityBar& bar = memory.bars.longest[k];
    const std::size_t row = row_of_bar(memory, page, k);
    const bool there = row != ShownLives::kNoRow;
    add_bar(
        bars, bar, k,
        there ? plot_colour(cavity_colour(page, row)) : plot_ink(ChartColourRole::muted, 0.45f));
    const auto top = static_cast<double>(k);
    ctx.rects["curves.life." + std::to_string(k + 1)] = {
        area.x_of(std::max(bar.born_angstrom2, area.x.low)), area.y_of(top),
        area.x_of(bar.gone_angstrom2), area.y_of(top + 1)};
    const auto& chosen = page.selected_rows;
    if (!there || !std::binary_search(chosen.begin(), chosen.end(), row)) continue;
    bars.plot.boxes.push_back({std::max(bar.born_angstrom2, area.x.low) - edge,
                               bar.gone_angstrom2 + edge, top, top + 1,
                               plot_ink(ChartColourRole::text), false});
  }
}

}  // namespace alphascope
