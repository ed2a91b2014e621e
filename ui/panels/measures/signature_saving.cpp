// SPDX-License-Identifier: GPL-3.0-or-later
// Saves the signature as a table or a figure.
#include <string>
#include <utility>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/chart/plot.hpp"
#include "core/chart/svg.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/measures/signature_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

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

}  // namespace

void signature_save_button(PanelContext& ctx, const Signature& signature) {
  ImGui::SameLine(0, ctx.px(10));
  ImGui::BeginDisabled(!ctx.state.references);
  if (button(ctx, "signature.save", "Save…")) {
    const Plot plot = plot_of_all(signature, signature_range(ctx, signature));
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

}  // namespace alphascope
