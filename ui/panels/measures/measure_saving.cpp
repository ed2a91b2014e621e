// SPDX-License-Identifier: GPL-3.0-or-later
// Copies and saves the table of areas and volumes.
#include <string>

#include "core/document/export/record_source.hpp"
#include "core/document/measures/measure_tables.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/measures/measure_parts.hpp"
#include "ui/panels/measures/measure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void measure_save_buttons(PanelContext& ctx, MeasureState& memory) {
  if (button(ctx, "measures.copy", "Copy CSV")) memory.copying = true;
  tooltip(ctx, "Copies the listed rows with all digits and their provenance.");
  ImGui::SameLine(0, ctx.px(4));
  ImGui::BeginDisabled(!memory.rows || !ctx.inputs.atoms || !shows_these_balls(ctx));
  if (button(ctx, "measures.save", "Save…")) {
    const RecordSource source = source_on_screen(ctx);
    open_save_dialog(ctx, {"Areas and volumes", file_name_for(ctx, "measures"),
                           measure_csv(memory.query, source, ctx.state.result),
                           measure_json(memory.query, source, ctx.state.result), ctx.inputs});
  }
  ImGui::EndDisabled();
  tooltip(ctx, "Saves the listed rows as CSV or JSON.");
}

void copy_measures_when_there(PanelContext& ctx, MeasureState& memory) {
  const Derived<std::string> csv = ctx.store.want(
      measure_csv(memory.query, source_on_screen(ctx), ctx.state.result), ctx.inputs);
  if (csv.state == DerivedState::failed || csv.state == DerivedState::no_room) {
    memory.copying = false;
    ctx.state.show_error("Cannot copy the table", csv.why, ErrorKind::computing);
  }
  if (!csv.ready()) return;
  ImGui::SetClipboardText(csv.value->c_str());
  ctx.state.notice = "Areas and volumes copied as CSV.";
  memory.copying = false;
}

}  // namespace alphascope
