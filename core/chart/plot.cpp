// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out plots: frame, ticks, numbers and labels, then all that is over the axes.
#include "core/chart/plot.hpp"

#include <utility>

#include "core/chart/ticks.hpp"

namespace alphascope {
namespace {

constexpr float kGap = 6, kTick = 3;  // pixels at scale 1
constexpr float kXDistance = 65;      // least distance of numbers below the plot
constexpr float kYDistance = 1.8f;    // least distance of numbers at its left, lines of text
constexpr ChartPaint kGrid{ChartColourRole::grid, {}, 0.6f};

class PlotLayout {
 public:
  PlotLayout(const Plot& plot, const PlotArea& area, const ChartFont& type)
      : plot_(plot), area_(area), type_(type) {}

  ChartDrawing run() {
    if (plot_.y.numbered) value_ticks();
    if (plot_.x.numbered) ticks();
    labels();
    for (const PlotBox& box : plot_.boxes) add(box);
    for (const PlotCurve& curve : plot_.curves) add(curve);
    for (const PlotLine& line : plot_.lines) {
      const float x = area_.x_of(line.x);
      drawing_.paths.push_back({{{x, area_.top}, {x, area_.bottom}}, line.paint, px(line.width)});
    }
    for (const PlotDot& dot : plot_.dots) {
      drawing_.dots.push_back(
          {area_.x_of(dot.x), area_.y_of(dot.y), dot.paint, {}, px(dot.radius), dot.ring});
    }
    return std::move(drawing_);
  }

 private:
  float px(float pixels_at_scale_1) const { return pixels_at_scale_1 * type_.pixel; }

  void text(float x, float y, const std::string& what, ChartAnchor anchor) {
    if (!what.empty())
      drawing_.texts.push_back({x, y, what, ChartColourRole::muted, anchor, false});
  }

  static double step_of(const PlotAxis& axis, float length, float distance) {
    const double step = nice_step(axis.range.high - axis.range.low,
                                  static_cast<int>(length / std::max(distance, 1.0f)));
    return axis.whole ? std::max(step, 1.0) : step;
  }

  void value_ticks() {
    const double step = step_of(plot_.y, area_.height(), kYDistance * type_.font);
    for (const double value : round_values(plot_.y.range.low, plot_.y.range.high, step)) {
      const float y = area_.y_of(value);
      drawing_.lines.push_back({area_.left, y, area_.right, y, kGrid});
      text(area_.left - px(kGap), y, tick_text(value, step), ChartAnchor::end);
    }
  }

  void ticks() {
    const PlotAxis& axis = plot_.x;
    const double step = step_of(axis, area_.width(), px(kXDistance));
    const std::vector<double> values =
        round_values(axis.range.low + axis.offset, axis.range.high + axis.offset, step);
    for (const double value : values) {
      const float x = area_.x_of(value - axis.offset);
      const bool first = value == values.front();
      const std::string number =
          tick_text(value, step) + (first && !axis.unit.empty() ? " " + axis.unit : "");
      if (plot_.numbers_above) {
        drawing_.lines.push_back({x, area_.top, x, area_.bottom, kGrid});
        text(x, area_.top - type_.font / 2 - px(1), number, ChartAnchor::start);
        continue;
      }
      if (!plot_.y.numbered) drawing_.lines.push_back({x, area_.top, x, area_.bottom, kGrid});
      drawing_.lines.push_back(
          {x, area_.bottom, x, area_.bottom + px(kTick), {ChartColourRole::muted, {}, 1}});
      text(x, area_.bottom + px(kTick) + type_.font / 2, number, ChartAnchor::middle);
    }
  }

  void labels() {
    if (!plot_.numbers_above) {
      drawing_.boxes.push_back({area_.left,
                                area_.top,
                                area_.width(),
                                area_.height(),
                                {ChartColourRole::grid},
                                {},
                                false});
    }
    text((area_.left + area_.right) / 2, area_.bottom + px(kTick) + 1.5f * type_.font,
         plot_.x.label, ChartAnchor::middle);
    if (plot_.value_label == PlotLabel::above) {
      text(area_.left, area_.top - px(kTick) - type_.font / 2, plot_.y.label, ChartAnchor::start);
    } else {
      text(area_.right - px(kGap), area_.top + px(kTick) + type_.font / 2, plot_.y.label,
           ChartAnchor::end);
    }
  }

  void add(const PlotBox& box) {
    const float x0 = area_.x_of(box.x0), y0 = area_.y_of(box.y0), y1 = area_.y_of(box.y1);
    const float x1 = std::max(area_.x_of(box.x1), x0 + px(1));
    drawing_.boxes.push_back({x0,
                              std::min(y0, y1),
                              x1 - x0,
                              std::fabs(y1 - y0),
                              box.paint,
                              {},
                              box.filled,
                              px(box.rounding)});
  }

  void add(const PlotCurve& curve) {
    std::vector<ChartPoint> line;
    const auto finish = [&] {
      if (curve.dots || line.size() == 1) {
        for (const ChartPoint& p : line) {
          drawing_.dots.push_back({p.x, p.y, curve.paint, {}, px(2.2f)});
        }
      }
      if (line.size() > 1) {
        drawing_.paths.push_back({std::move(line), curve.paint, px(curve.width)});
      }
      line.clear();
    };
    const PlotRange& x = area_.x;
    for (const PlotCurve::Point& point : curve.points) {
      if (point.y && point.x >= x.low && point.x <= x.high) {
        line.push_back({area_.x_of(point.x), area_.y_of(*point.y)});
      } else {
        finish();
      }
    }
    finish();
  }

  const Plot& plot_;
  const PlotArea& area_;
  const ChartFont& type_;
  ChartDrawing drawing_;
};

}  // namespace

ChartDrawing lay_out(const Plot& plot, const PlotArea& area, const ChartFont& type) {
  return PlotLayout(plot, area, type).run();
}

std::optional<std::size_t> nearest_point(const PlotCurve& curve, double x) {
  const auto& points = curve.points;
  if (points.empty()) return {};
  const auto after =
      std::lower_bound(points.begin(), points.end(), x,
                       [](const PlotCurve::Point& p, double at) { return p.x < at; });
  const auto n = static_cast<std::size_t>(after - points.begin());
  if (n == points.size()) return n - 1;
  const bool before = n > 0 && x - points[n - 1].x <= points[n].x - x;
  return before ? n - 1 : n;
}

}  // namespace alphascope
