// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the signature: numbers of simplices and the Euler characteristic against alpha.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/chart/ticks.hpp"
#include "core/document/alpha/signature.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/measures/signature_parts.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr double kLeastHigh = 10;  // Å², the right end of the axis, unless alpha is larger

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

}  // namespace

Rgb8 signature_colour(int dimension) {
  return chart_colour(static_cast<std::size_t>(dimension));
}

PlotRange signature_range(const PanelContext& ctx, const Signature& signature) {
  const double shown = ctx.inputs.alpha_angstrom2;
  const double high = std::max(kLeastHigh, shown);
  return {std::min({signature.least_alpha(), shown, high - 1}), high};
}

Plot plot_of_counts(const Signature& signature, const PlotRange& alpha,
                    const std::vector<double>& alphas) {
  Plot plot;
  plot.x = {.range = alpha, .numbered = false};
  plot.y = {.label = "simplices", .whole = true};
  for (int d = 0; d < 4; ++d) {
    plot.curves.push_back(sampled(alphas, [&](double at) { return signature.count(d, at); }));
    plot.curves.back().name = kSimplexNames[d];
    plot.curves.back().paint = plot_colour(signature_colour(d));
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

}  // namespace alphascope
