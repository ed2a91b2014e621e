// From a chart to boxes, lines and texts at places, for whatever can draw these.
#pragma once

#include <functional>

#include "core/chart/chart.hpp"

namespace alphascope {

enum class ChartInk { text, muted, grid, axis };

// Pixels from the top left; y points down.
struct ChartBox {
  float x, y, width, height;
  std::size_t series;
  std::string tip;  // what it says: "4hhb, tuples-cpu: 3.2"
};
struct ChartLine {
  float x0, y0, x1, y1;
  ChartInk ink = ChartInk::grid;
  std::optional<std::size_t> series = {};  // then in its colour
  bool dashed = false;
};
struct ChartDot {
  float x, y;
  std::size_t series;
  std::string tip;
};
enum class ChartAnchor { start, middle, end };
struct ChartText {
  float x, y;  // y of the text's middle
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

// `font` is the height of ordinary text in pixels, `text_width` measures it.
struct ChartType {
  float font = 13;
  std::function<float(const std::string&)> text_width;
};

// The height follows from the chart.
ChartDrawing lay_out(const Chart& chart, float width, const ChartType& type);

}  // namespace alphascope
