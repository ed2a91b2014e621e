// SPDX-License-Identifier: GPL-3.0-or-later
// The table of measured distances and angles, which selects, removes and copies them.
#include <imgui.h>

#include "core/document/commands/commands.hpp"
#include "core/document/reference/measurement_columns.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/tables/column.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/selection_error.hpp"
#include "ui/annotation_layer.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void command_button(PanelContext& ctx, const char* name, const char* label, const char* id) {
  const CommandSpec* const spec = ctx.commands.find(id);
  const std::string reason = spec->reason_against();
  ImGui::BeginDisabled(!reason.empty());
  if (button(ctx, name, label)) run_command(ctx, *spec);
  ImGui::EndDisabled();
  tooltip(ctx, (reason.empty() ? spec->help + "." : reason).c_str());
}

const Column<MeasurementRow>& column(const char* id) {
  return column_of(measurement_columns(), id);
}

// Draws a row. Returns whether its measurement is to be removed.
bool draw_row(PanelContext& ctx, std::size_t row) {
  ViewState& s = ctx.state;
  const Measurement& m = s.settings.annotations.measurements[row];
  const Molecule& molecule = s.references->molecule();
  const MeasurementRow cells{molecule, m, row + 1};
  const std::string number = column("number").shown_text(cells);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(row));
  const RefSet atoms(std::vector<Ref>(m.atoms.begin(), m.atoms.end()));
  if (ImGui::Selectable(
          number.c_str(), s.settings.selection.items == atoms,
          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap)) {
    s.settings.selection.items = atoms;
  }
  record(ctx, ("details.measured." + number).c_str());
  tooltip(ctx, (measurement_text(molecule, m) +
                "\nClick to select its atoms; press Z to move the view to them.")
                   .c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(column("kind").shown_text(cells).c_str());
  ImGui::TableNextColumn();
  const std::string between = column("between").shown_text(cells);
  ImGui::TextUnformatted(fitted_text(between, ImGui::GetContentRegionAvail().x).c_str());
  number_cell(measured_text(m, cells.of));
  ImGui::TableNextColumn();
  const bool removes = row_button(ctx, ("details.remove." + number).c_str(), "×", 22);
  tooltip(ctx, "Removes it.");
  ImGui::PopID();
  return removes;
}

void table(PanelContext& ctx) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("measured", 5, kFlags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn(column("number").title, ImGuiTableColumnFlags_WidthFixed, ctx.px(30));
  ImGui::TableSetupColumn(column("kind").title, ImGuiTableColumnFlags_WidthFixed, ctx.px(62));
  ImGui::TableSetupColumn(column("between").title, ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn(column("value").title, ImGuiTableColumnFlags_WidthFixed, ctx.px(72));
  ImGui::TableSetupColumn("##remove", ImGuiTableColumnFlags_WidthFixed, ctx.px(26));
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  ImGui::TableHeadersRow();
  ImGui::PopStyleColor();
  Measurements& all = ctx.state.settings.annotations.measurements;
  std::size_t removed = all.size();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(all.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      if (draw_row(ctx, static_cast<std::size_t>(i))) removed = static_cast<std::size_t>(i);
    }
  }
  ImGui::EndTable();
  if (removed < all.size()) {
    run_command(ctx, *ctx.commands.find("measure.remove"), {std::to_string(removed + 1)});
  }
}

}  // namespace

void draw_measured_list(PanelContext& ctx) {
  command_button(ctx, "details.measure", "Measure (D)", "measure.atoms");
  ImGui::SameLine(0, ctx.px(4));
  command_button(ctx, "details.copy", "Copy CSV", "measure.copy");
  ImGui::SameLine(0, ctx.px(4));
  command_button(ctx, "details.remove_all", "Remove all", "measure.remove_all");
  if (ctx.state.settings.annotations.measurements.empty()) {
    muted_wrapped(ctx,
                  "Select two atoms (click, then Ctrl+click) and press D to measure their "
                  "distance. Three atoms give the angle at the second, four the dihedral angle.");
    return record(ctx, "details.nothing_measured");
  }
  table(ctx);
}

}  // namespace alphascope
