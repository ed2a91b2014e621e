// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of a chart of bars or lines with title, legend and caption.
#pragma once

namespace alphascope {

struct Chart;
struct ChartDrawing;
struct ChartFont;

// Lays out a chart of this width (pixels). The height follows from the content.
ChartDrawing lay_out(const Chart& chart, float width, const ChartFont& type);

}  // namespace alphascope
