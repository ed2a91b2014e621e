// SPDX-License-Identifier: GPL-3.0-or-later
// The section on the molecule: opens files, and shows the name, dropped atoms and notes. It also
// draws the rows of the other sources of this folder.
#include "ui/calls.hpp"
#include "ui/panels/molecule/molecule_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void sample_popup(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (!ImGui::BeginPopup("samples")) return;
  close_on_escape();
  for (std::size_t i = 0; i < s.samples.size(); ++i) {
    if (ImGui::MenuItem(s.samples[i].name.c_str(), s.samples[i].detail.c_str())) {
      ctx.calls.files.open(s.samples[i].path);
    }
    record(ctx, ("molecule.sample." + std::to_string(i)).c_str());
  }
  ImGui::EndPopup();
}

void open_buttons(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  const auto kind = s.molecule.loaded ? ButtonKind::normal : ButtonKind::primary;
  if (button(ctx, "molecule.open", "Open…", {half, 0}, kind)) open_browser(s);
  ImGui::SameLine();
  ImGui::BeginDisabled(s.samples.empty());
  if (button(ctx, "molecule.sample", "Sample molecule", {half, 0})) ImGui::OpenPopup("samples");
  ImGui::EndDisabled();
  if (s.samples.empty()) tooltip(ctx, "The folder with the sample molecules was not found.");
  sample_popup(ctx);
}

void dropped(PanelContext& ctx) {
  const MoleculeInfo& m = ctx.state.molecule;
  if (m.dropped.empty()) return nothing_to_disclose(ctx, "No atom was dropped.");
  const std::string title = with_separators(static_cast<long long>(m.dropped_atoms)) +
                            (m.dropped_atoms == 1 ? " atom was dropped" : " atoms were dropped");
  if (!disclosure(ctx, "molecule.dropped", title, ctx.palette.text_muted)) return;
  for (const DroppedRow& row : m.dropped) {
    ImGui::TextUnformatted(row.text.c_str());
    if (row.detail.empty()) continue;
    ImGui::PushFont(ctx.fonts.small);
    muted_wrapped(ctx, row.detail);
    ImGui::PopFont();
  }
  ImGui::TreePop();
}

void notes(PanelContext& ctx) {
  const auto& list = ctx.state.molecule.notes;
  if (list.empty()) return nothing_to_disclose(ctx, "No notes on this molecule.");
  const std::string title =
      list.size() == 1
          ? "1 note on this molecule"
          : with_separators(static_cast<long long>(list.size())) + " notes on this molecule";
  if (!disclosure(ctx, "molecule.notes", title, ctx.palette.warning)) return;
  for (const std::string& note : list) muted_wrapped(ctx, note);
  ImGui::TreePop();
}

void draw_molecule(PanelContext& ctx, MoleculeState& memory) {
  if (!section(ctx, "molecule", "Molecule")) return;
  open_buttons(ctx);
  const MoleculeInfo& m = ctx.state.molecule;
  if (!m.loaded) {
    muted_wrapped(ctx, "Nothing is open yet.");
    return;
  }
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(ctx.fonts.strong);
  ImGui::TextUnformatted(fitted_text(m.name, width).c_str());
  ImGui::PopFont();
  record(ctx, "molecule.name");
  tooltip(ctx, ((m.folder.empty() ? "" : m.folder + "\n") + m.format).c_str());
  if (!m.title.empty()) {
    muted_text(ctx, fitted_text(m.title, width));
    tooltip(ctx, m.title.c_str());
  }
  constexpr int kSummaryLines = 2;  // enough for most molecules, whatever is selected
  const float top = ImGui::GetCursorPosY();
  ImGui::BeginGroup();
  wrapped_text(m.summary);
  ImGui::EndGroup();
  record(ctx, "molecule.summary");
  reserve_lines(top, kSummaryLines);
  dropped(ctx);
  notes(ctx);
  draw_residue_rows(ctx, memory);
  draw_source_rows(ctx);
  draw_radii_rows(ctx, memory);
  draw_selection_rows(ctx, memory);
  draw_provenance(ctx);
}

}  // namespace

std::unique_ptr<Panel> molecule_panel() {
  return panel_of(draw_molecule);
}

}  // namespace alphascope
