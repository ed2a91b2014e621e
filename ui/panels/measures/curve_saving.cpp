// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the curves, and saves them as a table or a figure.
#include <string>
#include <vector>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/chart/svg.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/measures/curves_plot.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

std::string csv_of(const PanelContext& ctx, const CurveState& memory) {
  std::vector<std::string> comments = comments_on_screen(ctx);
  if (memory.chart_axis != CurveAxis::solvent) {
    comments.push_back("solvent radius: " +
                       axis_text(CurveAxis::solvent, ctx.inputs.solvent_radius_angstrom) + " Å");
  }
  if (memory.chart_axis != CurveAxis::alpha) {
    comments.push_back("alpha: " + axis_text(CurveAxis::alpha, ctx.inputs.alpha_angstrom2) + " Å²");
  }
  if (!memory.chart.traced.empty()) {
    comments.push_back(memory.curves ? "radii: steps of 0.1 Å, and those of tables on screen"
                                     : "radii: those of tables on screen");
  }
  comments.push_back("values: " + memory.chart.chart.value_label);
  return chart_csv(memory.chart.chart, comments);
}

}  // namespace

void curves_save_buttons(PanelContext& ctx, const CurveState& memory, bool current) {
  ImGui::BeginDisabled(!current || !ctx.state.references);
  if (button(ctx, "curves.copy", "Copy CSV")) {
    ImGui::SetClipboardText(csv_of(ctx, memory).c_str());
    ctx.state.notice = "Curves copied as CSV.";
  }
  tooltip(ctx, "Copies the curves as CSV.");
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "curves.save", "Save…")) {
    open_save_dialog(
        ctx, {"Curves",
              file_name_for(ctx, "curves"),
              finished_text(csv_of(ctx, memory)),
              {},
              {},
              false,
              {figure_to_save(plot_svg(curves_plot(memory, shown_on_axis(ctx, memory.chart_axis)),
                                       ctx.state.file_name()))}});
  }
  tooltip(ctx, "Saves the curves as a CSV file, or their plot as an SVG file.");
  ImGui::EndDisabled();
}

}  // namespace alphascope
