// Draws axes, lines, marks and the cursor of a CurvePlot.
#include "ui/widgets/curve_plot.hpp"

#include <algorithm>
#include <cmath>

#include "core/chart/readable_number.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot_axis.hpp"

namespace alphascope {
namespace {

struct Place {
  ImVec2 from, to;  // pixels: top left and bottom right corners of the chart's area
  PlotRange x, y;

  float x_of(double value) const {
    return from.x + static_cast<float>(x.share(value)) * (to.x - from.x);
  }
  float y_of(double value) const {
    return to.y - static_cast<float>(y.share(value)) * (to.y - from.y);
  }
  double at(float pixel) const {
    return x.low + (x.high - x.low) * static_cast<double>((pixel - from.x) / (to.x - from.x));
  }
};

ImU32 ink(const CurvePlot& plot, std::size_t series) {
  const Rgb8& c = (*plot.colours)[series];
  return IM_COL32(c.r, c.g, c.b, static_cast<int>(255 * ImGui::GetStyle().Alpha));
}

const std::vector<ChartSeries>& series_of(const CurvePlot& plot) {
  return plot.chart->chart.series;
}

// The x range covers the present setting and all samples with a value other than 0. For models it
// covers all samples. The y range begins at 0.
void set_ranges(const CurvePlot& plot, Place& place) {
  place.x.take(plot.shown);
  place.y.take(0);
  for (const ChartSeries& series : series_of(plot)) {
    for (std::size_t n = 0; n < series.x.size(); ++n) {
      if (series.values[n]) place.y.take(*series.values[n]);
      const bool empty = !series.values[n] || *series.values[n] == 0;
      if (!empty || plot.axis == CurveAxis::model) place.x.take(series.x[n]);
    }
  }
  if (place.y.high <= place.y.low) place.y.high = place.y.low + 1;
  place.y.high += (place.y.high - place.y.low) * 0.04;
  const double margin =
      std::max((place.x.high - place.x.low) * 0.04, plot.axis == CurveAxis::model ? 0.5 : 0.1);
  place.x.low -= margin;
  place.x.high += margin;
  if (plot.axis == CurveAxis::solvent) place.x.low = std::max(place.x.low, 0.0);
}

void frame(PanelContext& ctx, const CurvePlot& plot, const Place& place) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 muted = to_u32(ctx.palette.text_muted);
  const float line = ImGui::GetTextLineHeight();
  const int most_y = static_cast<int>((place.to.y - place.from.y) / (2.2f * line));
  for_ticks(place.y, tick_step(place.y, most_y), [&](double value) {
    const float y = place.y_of(value);
    const std::string text = chart_number(value);
    draw->AddLine({place.from.x, y}, {place.to.x, y}, to_u32(ctx.palette.border, 0.6f));
    draw->AddText({place.from.x - ImGui::CalcTextSize(text.c_str()).x - ctx.px(6), y - line / 2},
                  muted, text.c_str());
  });
  const int most_x = static_cast<int>((place.to.x - place.from.x) / ctx.px(70));
  double step = tick_step(place.x, most_x);
  if (plot.axis == CurveAxis::model) step = std::max(std::round(step), 1.0);
  const double offset = plot.axis == CurveAxis::model ? 1 : 0;  // models are numbered from 1
  const PlotRange labels{place.x.low + offset, place.x.high + offset};
  for_ticks(labels, step, [&](double value) {
    const float x = place.x_of(value - offset);
    const std::string text = short_number_text(value, 2);
    draw->AddLine({x, place.to.y}, {x, place.to.y + ctx.px(3)}, muted);
    draw->AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, place.to.y + ctx.px(3)}, muted,
                  text.c_str());
  });
  draw->AddRect(place.from, place.to, to_u32(ctx.palette.border));
  const Chart& chart = plot.chart->chart;
  // Curves fall to the right, so the top right has room for the label.
  const float of_values = ImGui::CalcTextSize(chart.value_label.c_str()).x;
  draw->AddText({place.to.x - of_values - ctx.px(6), place.from.y + ctx.px(3)}, muted,
                chart.value_label.c_str());
  const float width = ImGui::CalcTextSize(chart.x_label.c_str()).x;
  draw->AddText({(place.from.x + place.to.x - width) / 2, place.to.y + ctx.px(3) + line}, muted,
                chart.x_label.c_str());
}

void curves(PanelContext& ctx, const CurvePlot& plot, const Place& place) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (std::size_t s = 0; s < series_of(plot).size(); ++s) {
    const ChartSeries& series = series_of(plot)[s];
    std::vector<ImVec2> line;
    const auto finish = [&] {
      draw->AddPolyline(line.data(), static_cast<int>(line.size()), ink(plot, s), 0, ctx.px(1.8f));
      const bool dots = plot.axis == CurveAxis::model || line.size() == 1;
      for (const ImVec2& p : line) {
        if (dots) draw->AddCircleFilled(p, ctx.px(2.2f), ink(plot, s));
      }
      line.clear();
    };
    for (std::size_t n = 0; n < series.x.size(); ++n) {
      if (series.values[n]) {
        line.push_back({place.x_of(series.x[n]), place.y_of(*series.values[n])});
      } else {
        finish();
      }
    }
    finish();
  }
}

void marks(PanelContext& ctx, const CurvePlot& plot, const Place& place) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const CurveMark& mark : plot.chart->marks) {
    const ChartSeries& series = series_of(plot)[mark.series];
    const ImVec2 at{place.x_of(series.x[mark.sample]), place.y_of(*series.values[mark.sample])};
    draw->AddCircleFilled(at, ctx.px(3.6f), to_u32(ctx.palette.panel));
    draw->AddCircle(at, ctx.px(3.6f), ink(plot, mark.series), 0, ctx.px(1.5f));
  }
}

// Index of the sample nearest to `at`, a position on the x axis.
std::size_t sample_at(const CurvePlot& plot, double at) {
  const std::vector<double>& x = series_of(plot).front().x;
  const auto nearer = [&](double a, double b) { return std::fabs(a - at) < std::fabs(b - at); };
  return static_cast<std::size_t>(std::min_element(x.begin(), x.end(), nearer) - x.begin());
}

std::string cursor_text(const CurvePlot& plot, std::size_t sample) {
  const double at = series_of(plot).front().x[sample];
  std::string text = plot.axis == CurveAxis::model ? "model " : "";
  text += axis_text(plot.axis, at) + (plot.unit.empty() ? "" : " " + plot.unit);
  for (std::size_t s = 0; s < series_of(plot).size(); ++s) {
    const ChartSeries& series = series_of(plot)[s];
    text += "\n" + series.name + ": " +
            (series.values[sample] ? chart_number(*series.values[sample]) + " " + plot.value_unit
                                   : std::string("none"));
    for (const CurveMark& mark : plot.chart->marks) {
      if (mark.series == s && mark.sample == sample) text += "\n    " + mark.text;
    }
  }
  return text + "\n" + plot.click;
}

void cursor(PanelContext& ctx, const CurvePlot& plot, const Place& place) {
  const std::size_t sample = sample_at(plot, place.at(ImGui::GetIO().MousePos.x));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const double at = series_of(plot).front().x[sample];
  if (at < place.x.low || at > place.x.high) return;
  const float x = place.x_of(at);
  draw->AddLine({x, place.from.y}, {x, place.to.y}, to_u32(ctx.palette.text_muted, 0.7f));
  for (std::size_t s = 0; s < series_of(plot).size(); ++s) {
    const auto& value = series_of(plot)[s].values[sample];
    if (value) draw->AddCircleFilled({x, place.y_of(*value)}, ctx.px(3), ink(plot, s));
  }
  ImGui::SetTooltip("%s", cursor_text(plot, sample).c_str());
}

}  // namespace

std::optional<double> draw_curve_plot(PanelContext& ctx, const CurvePlot& plot) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  Place place;
  set_ranges(plot, place);
  place.from = {corner.x + ctx.px(56), corner.y + ctx.px(2)};
  place.to = {corner.x + room.x - ctx.px(16),
              corner.y + room.y - 2 * ImGui::GetTextLineHeight() - ctx.px(6)};
  if (place.to.y - place.from.y < ctx.px(40) || place.to.x - place.from.x < ctx.px(120)) return {};
  frame(ctx, plot, place);
  const float shown = place.x_of(plot.shown);
  ImGui::GetWindowDrawList()->AddLine({shown, place.from.y}, {shown, place.to.y},
                                      to_u32(ctx.palette.accent), ctx.px(1.5f));
  curves(ctx, plot, place);
  marks(ctx, plot, place);
  ImGui::SetCursorScreenPos(place.from);
  ImGui::InvisibleButton("##curves", {place.to.x - place.from.x, place.to.y - place.from.y});
  record(ctx, "curves.plot");
  if (ImGui::IsItemHovered()) cursor(ctx, plot, place);
  if (!ImGui::IsItemActive()) return {};
  return std::clamp(place.at(ImGui::GetIO().MousePos.x), place.x.low, place.x.high);
}

}  // namespace alphascope
