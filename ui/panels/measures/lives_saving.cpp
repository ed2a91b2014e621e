// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the lives of cavities, and saves them as a table or a figure.
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/chart/svg.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/measures/lives_parts.hpp"
#include "ui/panels/measures/lives_plot.hpp"
#include "ui/panels/measures/lives_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void lives_save_buttons(PanelContext& ctx, const ShownLives& memory, const KnownLives& known) {
  const auto csv = [&] {
    std::vector<std::string> comments = comments_on_screen(ctx);
    comments.push_back(
        "solvent radius: " + short_number_text(ctx.inputs.solvent_radius_angstrom, 2) + " Å");
    return bars_csv(memory.bars.longest, *known.ground->triangulation, *ctx.inputs.atoms, comments);
  };
  ImGui::BeginDisabled(!known.current || !ctx.state.references);
  if (button(ctx, "curves.copy", "Copy CSV")) {
    ImGui::SetClipboardText(csv().c_str());
    ctx.state.notice = "Lives of cavities copied as CSV.";
  }
  tooltip(ctx, "Copies the range of alpha of each of these cavities, the longest first.");
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "curves.save", "Save…")) {
    std::vector<FormatToSave> figure;
    if (auto bars = place_bars(ctx, memory, ctx.state.alpha_angstrom2())) {
      add_bars(ctx, *bars, memory, *known.page);
      figure.push_back(figure_to_save(plot_svg(bars->plot, ctx.state.file_name())));
    }
    open_save_dialog(ctx, {"Lives of cavities",
                           file_name_for(ctx, "lives"),
                           finished_text(csv()),
                           {},
                           {},
                           false,
                           std::move(figure)});
  }
  tooltip(ctx, "The same as a CSV file, or the drawn bars as an SVG file.");
  ImGui::EndDisabled();
}

}  // namespace alphascope
