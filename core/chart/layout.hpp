// The layout of a chart: boxes, lines, dots and texts at positions, for any program that draws
// them.
#pragma once

#include <functional>

#include "core/chart/chart.hpp"

namespace alphascope {

enum class ChartInk { text, muted, grid, axis };

// Positions are in pixels from the top left; y points down.
struct ChartBox {
  float x, y, width, height;
  std::size_t series;
  std::string tip;  // tooltip: "4hhb, tuples-cpu: 3.2"
};
struct ChartLine {
  float x0, y0, x1, y1;
  ChartInk ink = ChartInk::grid;
  std::optional<std::size_t> series = {};  // if set, the line has its colour
  bool dashed = false;
};
struct ChartDot {
  float x, y;
  std::size_t series;
  std::string tip;
};
enum class ChartAnchor { start, middle, end };
struct ChartText {
  float x, y;  // y is that of the text's middle
  std::string text;
  ChartInk ink = ChartInk::text;
  ChartAnchor anchor = ChartAnchor::start;
  bool title = false;
};

struct ChartDrawing {
  float width = 0, height = 0;
  std::vector<ChartBox> boxes;
  std::vector<ChartLine> lines;
  std::vector<ChartDot> dots;
  std::vector<ChartText> texts;
};

// `font` is the height of ordinary text in pixels. `text_width` measures text in that font.
struct ChartType {
  float font = 13;
  std::function<float(const std::string&)> text_width;
};

// Lays out a chart of this width (pixels). The height follows from the content.
ChartDrawing lay_out(const Chart& chart, float width, const ChartType& type);

}  // namespace alphascope
