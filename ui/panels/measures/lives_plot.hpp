// SPDX-License-Identifier: GPL-3.0-or-later
// The bars of cavities as a plot.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/chart/plot.hpp"

namespace alphascope {

struct CavityBar;
struct CavityPage;
struct PanelContext;
struct PlotMouse;
struct ShownLives;

// The y axis counts the bars from the top.
struct BarsPlot {
  Plot plot = {};
  PlotArea area = {};
  std::size_t drawn = 0;

  float row() const { return area.y_of(1) - area.y_of(0); }  // pixels
  // Returns the bar under the mouse.
  std::optional<std::size_t> bar_at(const std::vector<CavityBar>& bars, const PlotMouse& at) const;
};
// Lays out as many bars as fit in the rest of the page. None: there is no room. `shown` is the
// present alpha.
std::optional<BarsPlot> place_bars(const PanelContext& ctx, const ShownLives& memory, double shown);
void add_bars(PanelContext& ctx, BarsPlot& bars, const ShownLives& memory, const CavityPage& page);

}  // namespace alphascope
