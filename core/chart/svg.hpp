// SPDX-License-Identifier: GPL-3.0-or-later
// Charts and plots as SVG 1.1, readable in browsers and word processors.
#pragma once

#include <filesystem>
#include <string>

#include "core/chart/plot.hpp"

namespace alphascope {

struct Chart;

// Complete documents on white.
std::string drawing_svg(const ChartDrawing& drawing);
std::string chart_svg(const Chart& chart, float width = 760);
// With a legend of the curves that have names.
std::string plot_svg(const Plot& plot, const std::string& title, float width = 760);

// Writes `folder`/<id>.svg for each chart and returns the paths. Creates the folder if it does not
// exist. Throws WriteError.
std::vector<std::filesystem::path> write_charts(const std::vector<Chart>& charts,
                                                const std::filesystem::path& folder);

}  // namespace alphascope
