// A chart as a picture of lines and text: SVG 1.1, readable in browsers and word processors.
#pragma once

#include <filesystem>
#include <string>

#include "core/chart/chart.hpp"

namespace alphascope {

// A whole document on white.
std::string chart_svg(const Chart& chart, float width = 760);

// Writes `folder`/<id>.svg for each, the folder too if need be; returns the paths. Throws
// WriteError.
std::vector<std::filesystem::path> write_charts(const std::vector<Chart>& charts,
                                                const std::filesystem::path& folder);

}  // namespace alphascope
