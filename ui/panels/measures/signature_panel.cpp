// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the signature: counts of simplices and the Euler characteristic against alpha. A
// cursor sets alpha, and marks in the view show which simplices appear there.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/chart/svg.hpp"
#include "core/chart/ticks.hpp"
#include "core/document/alpha/signature.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/calls.hpp"
#include "ui/layer.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/panel.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "core/document/settings/request.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/document/store/inputs.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/widgets/style.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/playback.hpp"

namespace alphascope {
namespace {

constexpr double kMarkedWithin = 0.02;  // Å², on either side of alpha
constexpr double kLeastHigh = 10;       // Å², the right end of the axis, unless alpha is larger
constexpr double kStep = 0.01;          // Å², as the slider's step
constexpr std::size_t kMostMarked = 20000;  // for each dimension; more would be a blur
constexpr const char* kNames[] = {"vertices", "edges", "triangles", "tetrahedra"};

// --- simplices that appear at the cursor

template <class List, class Simplices>
void collect(const List& list, float low, float high, Simplices& to) {
  for (std::size_t i = 0; i < list.size() && to.size() < kMostMarked; ++i) {
    const float value = list.alpha_values[i];
    if (value >= low && value <= high) to.push_back(list.simplices[i]);
  }
}

std::shared_ptr<const Layer> make_appearing(const Inputs& in, const RunContext& context) {
  const AlphaComplex& all = in.of(whole_filtration()).top();
  auto layer = std::make_shared<Layer>();
  layer->id = "signature.appearing";
  layer->key = key_of_balls_and_alpha(in).number();
  layer->balls = in.balls;
  const auto bound = [&](double alpha) {
    return all.lattice.alpha_on_lattice(alpha).nearest_float();
  };
  const float low = bound(in.alpha_angstrom2 - kMarkedWithin),
              high = bound(in.alpha_angstrom2 + kMarkedWithin);
  collect(all.tetrahedra, low, high, layer->tetrahedra);
  context.cancel.throw_if_cancelled();
  collect(all.triangles, low, high, layer->triangles);
  context.cancel.throw_if_cancelled();
  collect(all.edges, low, high, layer->edges);
  collect(all.vertices, low, high, layer->vertices);
  layer->colour = {1, 0.35f, 0.75f, 1};
  return layer;
}

const Definition<Layer>& appearing() {
  static const Definition<Layer> definition{{.id = "signature.appearing",
                                             .title = "Simplices that appear at this alpha",
                                             .made_of = {&whole_filtration()},
                                             .key = key_of_balls_and_alpha,
                                             .memory =
                                                 [](const Inputs&) {
                                                   constexpr std::uint64_t kMost =
                                                       kMostMarked * 10 * sizeof(BallIndex);
                                                   return MemoryNeed{kMost, kMost};
                                                 },
                                             .lane = Lane::interactive},
                                            make_appearing};
  return definition;
}

struct SignatureMemory {
  bool mark = false;  // the view marks the simplices that appear at alpha
};

void mark_what_appears(PanelContext& ctx, bool& on) {
  checkbox(ctx, "signature.mark", "Mark new simplices", on);
  tooltip(ctx,
          "Marks in the view the simplices whose alpha value is within 0.02 Å² of the present "
          "alpha, at most 20,000 of each dimension.");
  if (!on) return;
  // The layer never belongs to another alpha than the picture.
  const Derived<Layer> layer = ctx.store.want(appearing(), ctx.inputs);
  if (layer.ready()) ctx.state.layers.push_back(layer.value);
}

// --- the curves

Rgb8 series_colour(int dimension) {
  return chart_colour(static_cast<std::size_t>(dimension));
}

void legend_line(PanelContext& ctx, const Signature& signature, double alpha) {
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "α " + short_number_text(alpha, 2) + " Å²");
  for (int d = 0; d < 4; ++d) {
    legend_entry(ctx, series_colour(d),
                 std::string(kNames[d]) + " " +
                     with_separators(static_cast<long long>(signature.count(d, alpha))));
  }
  ImGui::SameLine(0, ctx.px(14));
  strong_text(ctx, "Euler χ " + with_separators(signature.euler(alpha)));
  record(ctx, "signature.values");
}

// Returns evenly spaced values of alpha, one for every two pixels.
std::vector<double> alphas_of(const PlotRange& range, float width) {
  std::vector<double> alphas;
  const int points = 1 + static_cast<int>(width / 2);
  for (int n = 0; n < points; ++n) {
    alphas.push_back(range.at(static_cast<double>(2 * static_cast<float>(n) / width)));
  }
  return alphas;
}

template <class Value>
PlotCurve sampled(const std::vector<double>& alphas, const Value& value) {
  PlotCurve curve{.width = 1.5f};
  for (const double at : alphas) curve.points.push_back({at, static_cast<double>(value(at))});
  return curve;
}

// The y range from 0 to 1 or further, as far as the curves reach.
void take_values(Plot& plot) {
  plot.y.range = {0, 1};
  for (const PlotCurve& curve : plot.curves) {
    for (const PlotCurve::Point& point : curve.points) plot.y.range.take(*point.y);
  }
}

Plot plot_of_counts(const Signature& signature, const PlotRange& alpha,
                    const std::vector<double>& alphas) {
  Plot plot;
  plot.x = {.range = alpha, .numbered = false};
  plot.y = {.label = "simplices", .whole = true};
  for (int d = 0; d < 4; ++d) {
    plot.curves.push_back(sampled(alphas, [&](double at) { return signature.count(d, at); }));
    plot.curves.back().name = kNames[d];
    plot.curves.back().paint = plot_colour(series_colour(d));
  }
  take_values(plot);
  return plot;
}

Plot plot_of_euler(const Signature& signature, const PlotRange& alpha,
                   const std::vector<double>& alphas) {
  Plot plot;
  plot.x = {.range = alpha, .unit = "Å²"};
  plot.y = {.label = "Euler χ", .whole = true};
  plot.curves.push_back(sampled(alphas, [&](double at) { return signature.euler(at); }));
  plot.curves.back().paint = plot_ink(ChartColourRole::text);
  take_values(plot);
  return plot;
}

PlotRange alpha_range(const PanelContext& ctx, const Signature& signature) {
  const double shown = ctx.inputs.alpha_angstrom2;
  const double high = std::max(kLeastHigh, shown);
  return {std::min({signature.least_alpha(), shown, high - 1}), high};
}

// All curves in one plot, at up to 500 round alphas.
Plot plot_of_all(const Signature& signature, const PlotRange& alpha) {
  std::vector<double> alphas =
      round_values(alpha.low, alpha.high, nice_step(alpha.high - alpha.low, 500));
  for (double& at : alphas) at = std::round(at * 1e6) / 1e6;  // 0.15, not 3 · 0.05
  Plot plot = plot_of_counts(signature, alpha, alphas);
  Plot euler = plot_of_euler(signature, alpha, alphas);
  plot.x = {.range = alpha, .label = "alpha (Å²)"};
  plot.y.label.clear();
  plot.curves.push_back(std::move(euler.curves.front()));
  plot.curves.back().name = "Euler characteristic";
  take_values(plot);
  return plot;
}

std::string csv_of(const Plot& plot, std::vector<std::string> comments, double solvent) {
  comments.push_back("solvent radius: " + short_number_text(solvent, 2) + " Å");
  Chart chart;
  chart.kind = ChartKind::lines;
  chart.x_label = plot.x.label;
  for (const PlotCurve& curve : plot.curves) {
    ChartSeries series;
    series.name = curve.name;
    for (const PlotCurve::Point& point : curve.points) {
      series.x.push_back(point.x);
      series.values.push_back(point.y);
    }
    chart.series.push_back(std::move(series));
  }
  return chart_csv(chart, comments);
}

void save_button(PanelContext& ctx, const Signature& signature) {
  ImGui::SameLine(0, ctx.px(10));
  ImGui::BeginDisabled(!ctx.state.references);
  if (button(ctx, "signature.save", "Save…")) {
    const Plot plot = plot_of_all(signature, alpha_range(ctx, signature));
    open_save_dialog(
        ctx,
        {"Signature",
         file_name_for(ctx, "signature"),
         finished_text(csv_of(plot, comments_on_screen(ctx), ctx.inputs.solvent_radius_angstrom)),
         {},
         {},
         false,
         {figure_to_save(plot_svg(plot, ctx.state.file_name()))}});
  }
  tooltip(ctx, "Numbers of simplices against alpha as a CSV file, or their plot as an SVG file.");
  ImGui::EndDisabled();
}

void plots(PanelContext& ctx, const Signature& signature) {
  const double shown = ctx.inputs.alpha_angstrom2;
  const auto area =
      plot_area(ctx, {.left = 64, .top = 0, .bottom = 22, .lines_below = 0, .least_height = 60});
  if (!area) return;
  const PlotRange alpha = alpha_range(ctx, signature);
  const float middle = area->top + area->height() * 0.62f;
  PlotArea above = *area, below = *area;
  above.bottom = middle - ctx.px(6);
  below.top = middle;
  const std::vector<double> alphas = alphas_of(alpha, area->width());
  Plot counts = plot_of_counts(signature, alpha, alphas);
  Plot euler = plot_of_euler(signature, alpha, alphas);
  for (Plot* plot : {&counts, &euler}) {
    plot->lines.push_back({shown, plot_ink(ChartColourRole::accent), 1.5f});
  }
  draw_plot(ctx, counts, above);
  draw_plot(ctx, euler, below);
  above.bottom = below.bottom;  // the mouse is over both
  const PlotMouse mouse = plot_mouse(ctx, above, "signature.plot");
  tooltip(ctx, "Click or drag to set alpha.");
  if (!mouse.held) return;
  set_alpha(ctx.state.settings.request, std::round(mouse.x / kStep) * kStep);
  ctx.state.playback.alpha = false;
}

// Says why there are no curves yet.
std::string waiting_text(const PanelContext& ctx, const Derived<Signature>& signature) {
  if (!ctx.state.has_molecule()) return "Open a molecule: its signature appears here.";
  if (signature.state != DerivedState::waiting && !signature.why.empty()) {
    return "There is no signature. " + signature.why;
  }
  if (!ctx.state.background.detail.empty()) return ctx.state.background.detail;
  return "The signature appears here when all simplices are known.";
}

void draw_signature(PanelContext& ctx, SignatureMemory& memory) {
  const Derived<Signature> signature = ctx.store.want(whole_signature(), ctx.inputs);
  mark_what_appears(ctx, memory.mark);
  if (!signature.ready()) {
    muted_wrapped(ctx, waiting_text(ctx, signature));
    record(ctx, "signature.waiting");
    return;
  }
  save_button(ctx, *signature.value);
  ImGui::SameLine(0, ctx.px(14));
  legend_line(ctx, *signature.value, ctx.inputs.alpha_angstrom2);
  ImGui::PushFont(ctx.fonts.small);
  plots(ctx, *signature.value);
  ImGui::PopFont();
}

}  // namespace

std::unique_ptr<Panel> signature_panel() {
  return panel_of(draw_signature);
}

}  // namespace alphascope
