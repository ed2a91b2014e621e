// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out charts: title, legend, axes, bars and curves.
#include "core/chart/layout.hpp"

#include <algorithm>
#include <cmath>

#include "core/chart/chart.hpp"
#include "core/chart/drawing.hpp"
#include "core/chart/readable_number.hpp"
#include "core/chart/ticks.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

// The axis is logarithmic from this ratio of values on. Small values would be unreadable on a
// linear one.
constexpr double kLogarithmicFrom = 30;
constexpr float kCurve = 2;  // width of curves, pixels

struct Range {
  double low = 0, high = 1;
  bool logarithmic = false;

  // position on the axis, 0 to 1
  double share(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return std::log(value / low) / std::log(high / low);
  }
};

std::vector<double> all_values(const Chart& chart) {
  std::vector<double> values;
  for (const ChartSeries& s : chart.series) {
    for (const auto& v : s.values) {
      if (v) values.push_back(*v);
    }
  }
  if (chart.reference) values.push_back(*chart.reference);
  return values;
}

std::vector<double> sums(const Chart& chart) {
  std::vector<double> totals(chart.categories.size(), 0);
  for (const ChartSeries& s : chart.series) {
    for (std::size_t c = 0; c < totals.size() && c < s.values.size(); ++c) {
      totals[c] += s.values[c].value_or(0);
    }
  }
  return totals;
}

Range range_of(const std::vector<double>& values, bool ratios, int ticks) {
  Range range;
  if (values.empty()) return range;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (ratios && *least > 0 && *most / *least > kLogarithmicFrom) {
    return {std::pow(10.0, std::floor(std::log10(*least) + 1e-9)),
            std::pow(10.0, std::ceil(std::log10(*most) - 1e-9)), true};
  }
  const double low = std::min(0.0, *least), high = std::max(0.0, *most);
  if (high == low) return range;
  const double step = nice_step(high - low, ticks);
  return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, false};
}

std::vector<double> ticks_of(const Range& range, int most) {
  std::vector<double> ticks;
  if (range.logarithmic) {
    const long decades = std::lround(std::log10(range.high / range.low));
    double tick = range.low;
    for (long n = 0; n <= decades; ++n) {
      ticks.push_back(tick);
      tick *= 10;
    }
    return ticks;
  }
  return round_values(range.low, range.high, nice_step(range.high - range.low, most));
}

ChartPaint paint_of_series(std::size_t n) {
  return {ChartColourRole::text, chart_colour(n), 1};
}

class Layout {
 public:
  Layout(const Chart& chart, float width, const ChartFont& type)
      : chart_(chart), type_(type), row_(type.font * 1.5f) {
    drawing_.width = width;
    right_ = width - type.font;
  }

  ChartDrawing run() {
    header();
    if (chart_.empty()) {
      text(type_.font, y_ + row_, "Nothing was measured for this figure.", ChartColourRole::muted);
      y_ += 2 * row_;
    } else if (chart_.kind == ChartKind::lines) {
      lines();
    } else {
      bars();
    }
    for (const std::string& line : wrapped(chart_.caption)) {
      text(type_.font, y_ + row_ / 2, line, ChartColourRole::muted);
      y_ += row_;
    }
    drawing_.height = y_ + type_.font / 2;
    return std::move(drawing_);
  }

 private:
  void text(float x, float y, const std::string& what, ChartColourRole ink = ChartColourRole::text,
            ChartAnchor anchor = ChartAnchor::start, bool title = false) {
    if (!what.empty()) drawing_.texts.push_back({x, y, what, ink, anchor, title});
  }

  std::vector<std::string> wrapped(const std::string& what) const {
    std::vector<std::string> lines;
    std::string line, word;
    const auto flush = [&] {
      if (word.empty()) return;
      const std::string longer = line.empty() ? word : line + " " + word;
      if (!line.empty() && type_.text_width(longer) > right_ - type_.font) {
        lines.push_back(line);
        line = word;
      } else {
        line = longer;
      }
      word.clear();
    };
    for (const char c : what) {
      if (c == ' ') {
        flush();
      } else {
        word += c;
      }
    }
    flush();
    if (!line.empty()) lines.push_back(line);
    return lines;
  }

  void header() {
    y_ = type_.font * 0.7f;
    for (const std::string& line : wrapped(chart_.title)) {
      text(type_.font, y_ + row_ / 2, line, ChartColourRole::text, ChartAnchor::start, true);
      y_ += row_ * 1.15f;
    }
    legend();
  }

  void legend() {
    if (chart_.series.size() < 2) return;
    float x = type_.font;
    const float swatch = type_.font * 0.8f;
    for (std::size_t s = 0; s < chart_.series.size(); ++s) {
      const float needed = swatch * 1.5f + type_.text_width(chart_.series[s].name);
      if (x > type_.font && x + needed > right_) {
        x = type_.font;
        y_ += row_;
      }
      if (chart_.kind == ChartKind::lines) {
        drawing_.lines.push_back({x, y_ + row_ / 2, x + swatch * 1.2f, y_ + row_ / 2,
                                  paint_of_series(s), kCurve, s >= kChartColours});
      } else {
        drawing_.boxes.push_back({x, y_ + (row_ - swatch) / 2, swatch, swatch, paint_of_series(s),
                                  chart_.series[s].name});
      }
      text(x + swatch * 1.5f, y_ + row_ / 2, chart_.series[s].name, ChartColourRole::text);
      x += needed + type_.font * 1.4f;
    }
    y_ += row_ * 1.2f;
  }

  float value_x(const Range& range, double value) const {
    return left_ + static_cast<float>(range.share(value)) * (end_ - left_);
  }

  // Draws the axis of values above horizontal bars, with grid lines down to `bottom`.
  void value_axis(const Range& range, int most, float bottom) {
    text(left_, y_ + row_ / 2, chart_.value_label, ChartColourRole::muted);
    y_ += row_;
    axis_top_ = y_ + row_;
    for (const double t : ticks_of(range, most)) {
      const float x = value_x(range, t);
      text(x, y_ + row_ / 2, chart_number(t), ChartColourRole::muted, ChartAnchor::middle);
      drawing_.lines.push_back({x, axis_top_, x, bottom, {ChartColourRole::grid}});
    }
    y_ += row_;
  }

  void bars() {
    const bool stacked = chart_.kind == ChartKind::stacked_bars;
    left_ = 2 * type_.font;
    for (const std::string& name : chart_.categories) {
      left_ = std::max(left_, type_.text_width(name) + 2 * type_.font);
    }
    left_ = std::min(left_, 0.4f * drawing_.width);
    end_ = right_ - room_for_labels();
    const int most = std::max(2, static_cast<int>((end_ - left_) / (6 * type_.font)));
    const Range range =
        range_of(stacked ? sums(chart_) : all_values(chart_), chart_.ratios && !stacked, most);
    const float bar = type_.font * 1.15f;
    const float group =
        bar * static_cast<float>(stacked ? 1 : chart_.series.size()) + type_.font * 0.8f;
    const float bottom = y_ + 2 * row_ + group * static_cast<float>(chart_.categories.size());
    value_axis(range, most, bottom);
    for (std::size_t c = 0; c < chart_.categories.size(); ++c) {
      text(left_ - type_.font * 0.7f, y_ + group / 2, chart_.categories[c], ChartColourRole::text,
           ChartAnchor::end);
      const float top = y_ + type_.font * 0.4f;
      stacked ? stack(range, c, top, bar) : grouped(range, c, top, bar);
      y_ += group;
    }
    zero_line(range, bottom);
    y_ = bottom + type_.font * 0.5f + (chart_.reference ? row_ : 0);
  }

  // The width for labels next to the longest bar.
  float room_for_labels() const {
    float room = 5 * type_.font;
    for (const ChartSeries& s : chart_.series) {
      for (const std::string& note : s.notes) {
        room = std::max(room, type_.text_width(note) + type_.font);
      }
    }
    return std::min(room, 0.3f * drawing_.width);
  }

  double base(const Range& range) const {
    return range.logarithmic ? chart_.reference.value_or(range.low) : 0;
  }

  void zero_line(const Range& range, float bottom) {
    const float start = value_x(range, base(range));
    drawing_.lines.push_back({start, axis_top_, start, bottom, {ChartColourRole::axis}});
    if (!chart_.reference) return;
    const float x = value_x(range, *chart_.reference);
    drawing_.lines.push_back({x, axis_top_, x, bottom, {ChartColourRole::axis}, 1, true});
    text(x, bottom + row_ / 2, chart_.reference_label, ChartColourRole::muted, ChartAnchor::middle);
  }

  std::string tip(std::size_t category, const ChartSeries& series, double value) const {
    return chart_.categories[category] + ", " + series.name + ": " + chart_number(value);
  }

  void grouped(const Range& range, std::size_t c, float first_top, float bar) {
    const float start = value_x(range, base(range));
    for (std::size_t s = 0; s < chart_.series.size(); ++s) {
      const ChartSeries& series = chart_.series[s];
      const float top = first_top + static_cast<float>(s) * bar;
      const float middle = top + bar / 2;
      const std::string note = c < series.notes.size() ? series.notes[c] : std::string();
      if (c >= series.values.size() || !series.values[c]) {
        text(start + type_.font * 0.4f, middle, note, ChartColourRole::muted);
        continue;
      }
      const double value = *series.values[c];
      const float end = value_x(range, value);
      drawing_.boxes.push_back({std::min(start, end), top + bar * 0.08f,
                                std::max(1.0f, std::fabs(end - start)), bar * 0.84f,
                                paint_of_series(s), tip(c, series, value)});
      text(std::max(start, end) + type_.font * 0.4f, middle,
           note.empty() ? chart_number(value) : note);
    }
  }

  void stack(const Range& range, std::size_t c, float top, float bar) {
    double sum = 0;
    for (std::size_t s = 0; s < chart_.series.size(); ++s) {
      const ChartSeries& series = chart_.series[s];
      if (c >= series.values.size() || !series.values[c]) continue;
      const float start = value_x(range, sum);
      sum += *series.values[c];
      drawing_.boxes.push_back({start, top, std::max(0.5f, value_x(range, sum) - start), bar,
                                paint_of_series(s), tip(c, series, *series.values[c])});
    }
    if (sum > 0) return;
    const auto has_note = [c](const ChartSeries& s) { return c < s.notes.size(); };
    const auto noted = std::find_if(chart_.series.begin(), chart_.series.end(), has_note);
    if (noted != chart_.series.end()) {
      text(left_ + type_.font * 0.4f, top + bar / 2, noted->notes[c], ChartColourRole::muted);
    }
  }

  Range x_range() const {
    Range range{HUGE_VAL, -HUGE_VAL, false};
    for (const ChartSeries& s : chart_.series) {
      for (const double x : s.x) {
        range.low = std::min(range.low, x);
        range.high = std::max(range.high, x);
      }
    }
    if (range.low >= range.high) range = {range.low - 0.5, range.low + 0.5, false};
    return range;
  }

  void lines() {
    const float height = std::max(12 * type_.font, 0.42f * drawing_.width);
    const int most_y = static_cast<int>(height / (3 * type_.font));
    const Range y_range = range_of(all_values(chart_), chart_.ratios, most_y), x = x_range();
    left_ = 2 * type_.font;
    const std::vector<double> ticks = ticks_of(y_range, most_y);
    for (const double t : ticks) {
      left_ = std::max(left_, type_.text_width(chart_number(t)) + 2 * type_.font);
    }
    end_ = right_ - 2 * type_.font;
    text(type_.font, y_ + row_ / 2, chart_.value_label, ChartColourRole::muted);
    const float top = y_ + row_ * 1.4f, bottom = top + height;
    const auto at = [&](double v) {
      return bottom - static_cast<float>(y_range.share(v)) * height;
    };
    for (const double t : ticks) {
      text(left_ - type_.font * 0.6f, at(t), chart_number(t), ChartColourRole::muted,
           ChartAnchor::end);
      drawing_.lines.push_back({left_, at(t), end_, at(t), {ChartColourRole::grid}});
    }
    const int most_x = std::max(2, static_cast<int>((end_ - left_) / (5 * type_.font)));
    for (const double t : ticks_of(x, most_x)) {
      text(value_x(x, t), bottom + row_ * 0.6f, chart_number(t), ChartColourRole::muted,
           ChartAnchor::middle);
      drawing_.lines.push_back(
          {value_x(x, t), bottom, value_x(x, t), bottom + 4, {ChartColourRole::axis}});
    }
    const double zero = y_range.logarithmic ? y_range.low : 0;
    drawing_.lines.push_back({left_, at(zero), end_, at(zero), {ChartColourRole::axis}});
    drawing_.lines.push_back({left_, top, left_, bottom, {ChartColourRole::axis}});
    if (chart_.reference) {
      const float y = at(*chart_.reference);
      drawing_.lines.push_back({left_, y, end_, y, {ChartColourRole::axis}, 1, true});
      text(end_, y - row_ / 2, chart_.reference_label, ChartColourRole::muted, ChartAnchor::end);
    }
    for (std::size_t s = 0; s < chart_.series.size(); ++s) curve(s, x, at);
    text((left_ + end_) / 2, bottom + row_ * 1.7f, chart_.x_label, ChartColourRole::muted,
         ChartAnchor::middle);
    y_ = bottom + row_ * 2.4f;
  }

  template <class At>
  void curve(std::size_t s, const Range& x, const At& at) {
    const ChartSeries& series = chart_.series[s];
    std::optional<ChartDot> last;
    for (std::size_t n = 0; n < series.x.size() && n < series.values.size(); ++n) {
      if (!series.values[n]) {
        last.reset();  // a missing value leaves a gap
        continue;
      }
      ChartDot dot{value_x(x, series.x[n]), at(*series.values[n]), paint_of_series(s),
                   series.name + ", " + chart_.x_label + " " + chart_number(series.x[n]) + ": " +
                       chart_number(*series.values[n]),
                   3.5f * type_.pixel};
      if (last) {
        drawing_.lines.push_back(
            {last->x, last->y, dot.x, dot.y, dot.paint, kCurve, s >= kChartColours});
      }
      drawing_.dots.push_back(dot);
      last = std::move(dot);
    }
  }

  const Chart& chart_;
  const ChartFont& type_;
  const float row_;
  ChartDrawing drawing_;
  float left_ = 0, end_ = 0, right_ = 0, axis_top_ = 0, y_ = 0;
};

}  // namespace

bool Chart::empty() const {
  for (const ChartSeries& s : series) {
    for (const auto& v : s.values) {
      if (v) return false;
    }
  }
  return true;
}

Rgb8 chart_colour(std::size_t n) {
  constexpr Rgb8 kColours[kChartColours] = {{0, 114, 178},   {230, 159, 0},  {0, 158, 115},
                                            {213, 94, 0},    {86, 180, 233}, {204, 121, 167},
                                            {148, 148, 148}, {190, 170, 50}};
  return kColours[n % kChartColours];
}

ChartDrawing lay_out(const Chart& chart, float width, const ChartFont& type) {
  return Layout(chart, width, type).run();
}

}  // namespace alphascope
