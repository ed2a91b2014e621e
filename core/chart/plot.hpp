// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as plain data: curves, boxes and dots over two axes, and the place where it is drawn. Its
// layout becomes a ChartDrawing. The window's mouse and its SVG use the same places.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/drawing.hpp"

namespace alphascope {

struct PlotRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double share(double value) const { return (value - low) / (high - low); }
  double at(double share) const { return std::lerp(low, high, share); }
};

struct PlotAxis {
  PlotRange range = {};    // low > high: the axis points the other way
  std::string label = {};  // with its unit
  bool numbered = true;    // false: neither ticks nor numbers
  bool whole = false;      // only whole numbers
  double offset = 0;       // added to the numbers, such as 1 for what is counted from 1
  std::string unit = {};   // written after the first number, for an axis without a label
};

struct PlotCurve {
  std::string name = {};
  struct Point {
    double x;
    std::optional<double> y;  // none: a gap
  };
  std::vector<Point> points = {};
  ChartPaint paint = {};
  float width = 1.8f;  // pixels at scale 1, as all lengths below
  bool dots = false;  // true: a dot at each point. A single point between two gaps always has a dot
};

struct PlotBox {
  double x0, x1, y0, y1;
  ChartPaint paint = {};
  bool filled = true;
  float rounding = 0;
};

struct PlotDot {
  double x, y;
  ChartPaint paint = {};
  float radius = 3.5f;
  bool ring = false;
};

// A vertical line through the whole plot.
struct PlotLine {
  double x;
  ChartPaint paint = {};
  float width = 1;
};

enum class PlotLabel { inside, above };  // place of the label of the y axis

struct Plot {
  PlotAxis x, y;
  PlotLabel value_label = PlotLabel::inside;
  bool numbers_above = false;  // those of the x axis; its ticks then go through the plot
  std::vector<PlotBox> boxes = {};
  std::vector<PlotCurve> curves = {};
  std::vector<PlotDot> dots = {};
  std::vector<PlotLine> lines = {};
};

// The rectangle of a plot without its numbers and labels, in pixels.
struct PlotArea {
  float left = 0, top = 0, right = 0, bottom = 0;
  PlotRange x, y;

  float x_of(double value) const {
    return left + static_cast<float>(x.share(value)) * (right - left);
  }
  float y_of(double value) const {
    return bottom - static_cast<float>(y.share(value)) * (bottom - top);
  }
  double x_at(float pixel) const {
    return x.at(static_cast<double>((pixel - left) / (right - left)));
  }
  double y_at(float pixel) const {
    return y.at(static_cast<double>((bottom - pixel) / (bottom - top)));
  }
  float width() const { return right - left; }
  float height() const { return bottom - top; }
};

// Both ranges of the area must be those of the axes. Points of curves beyond the x axis are left
// out.
ChartDrawing lay_out(const Plot& plot, const PlotArea& area, const ChartFont& type);

// The index of the point that is nearest to `x`. The points must be in ascending order of x.
// Without a point: none.
std::optional<std::size_t> nearest_point(const PlotCurve& curve, double x);

}  // namespace alphascope
