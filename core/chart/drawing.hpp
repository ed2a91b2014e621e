// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of a chart or plot: boxes, lines, curves, dots and texts at positions, for any program
// that draws them, and for SVG.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

// Colours of the surroundings, which differ between the window and paper.
enum class ChartColourRole { text, muted, grid, axis, accent, ground };

struct ChartPaint {
  ChartColourRole ink = ChartColourRole::grid;
  std::optional<Rgb8> colour = {};  // if set, in place of the ink
  float opacity = 1;
};

// Positions are in pixels from the top left; y points down. Later kinds are drawn over earlier
// ones: lines, boxes, paths, dots, texts.
struct ChartLine {
  float x0, y0, x1, y1;
  ChartPaint paint = {};
  float width = 1;
  bool dashed = false;
};
struct ChartBox {
  float x, y, width, height;
  ChartPaint paint = {};
  std::string tip = {};  // tooltip: "4hhb, tuples-cpu: 3.2"
  bool filled = true;    // false: only the border
  float rounding = 0;
};
struct ChartPoint {
  float x, y;
};
struct ChartPath {
  std::vector<ChartPoint> points;
  ChartPaint paint = {};
  float width = 1;
};
struct ChartDot {
  float x, y;
  ChartPaint paint = {};
  std::string tip = {};
  float radius = 3.5f;
  bool ring = false;  // a circle around a spot in the colour of the ground
};
enum class ChartAnchor { start, middle, end };
struct ChartText {
  float x, y;  // y is that of the text's middle
  std::string text;
  ChartColourRole ink = ChartColourRole::text;
  ChartAnchor anchor = ChartAnchor::start;
  bool title = false;
};

struct ChartDrawing {
  float width = 0, height = 0;
  std::vector<ChartLine> lines;
  std::vector<ChartBox> boxes;
  std::vector<ChartPath> paths;
  std::vector<ChartDot> dots;
  std::vector<ChartText> texts;
};

// `font` is the height of ordinary text in pixels. `text_width` measures text in that font. `pixel`
// is the length of a pixel at scale 1.
struct ChartFont {
  float font = 13;
  std::function<float(const std::string&)> text_width;
  float pixel = 1;
};

}  // namespace alphascope
