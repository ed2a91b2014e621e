// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view without a molecule, or without atoms.
#include <string>

#include "core/read/file_format.hpp"
#include "ui/calls.hpp"
#include "ui/panels/frame/overlay.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void draw_empty_view(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ViewState& s = ctx.state;
  if (s.molecule.loaded || awaited_job(s.jobs) != nullptr) return;
  begin_overlay(ctx, "##empty", {corner.x + size.x / 2, corner.y + size.y / 2}, {0.5f, 0.5f});
  ImGui::Dummy({ctx.px(460), ctx.px(2)});
  ImGui::PushFont(ctx.fonts.large);
  ImGui::TextUnformatted("Open a molecule to begin");
  ImGui::PopFont();
  muted_text(ctx,
             broken_lines("Drop a file here, or choose one: " + format_names() + "; plain or .gz.",
                          ctx.px(460)));
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "empty.open", "Open file…", {ctx.px(130), ctx.px(34)}, ButtonKind::primary)) {
    open_browser(s);
  }
  for (std::size_t i = 0; i < s.samples.size(); ++i) {
    ImGui::SameLine();
    const std::string label = "Try " + s.samples[i].name;
    const std::string name = "empty.sample." + std::to_string(i);
    if (button(ctx, name.c_str(), label.c_str(), {0, ctx.px(34)})) {
      ctx.calls.files.open(s.samples[i].path);
    }
    tooltip(ctx, s.samples[i].detail.c_str());
  }
  ImGui::Dummy({0, ctx.px(6)});
  muted_text(ctx, "Then move alpha: the exact alpha complex is recomputed");
  muted_text(ctx, "and compared with CGAL simplex by simplex.");
  muted_text(ctx, "Press F1 for mouse and keyboard.");
  ImGui::Dummy({0, ctx.px(2)});
  end_overlay();
}

bool no_atoms_note(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const MoleculeInfo& m = ctx.state.molecule;
  if (!m.loaded || m.balls > 0 || awaited_job(ctx.state.jobs) != nullptr) return false;
  begin_overlay(ctx, "##nothing", {corner.x + size.x / 2, corner.y + size.y / 2}, {0.5f, 0.5f});
  ImGui::TextUnformatted("The selection has no atoms, so there is nothing to show.");
  muted_text(ctx, "Keep more kinds of atoms or chains at the left, or clear the expression.");
  record(ctx, "view.nothing");
  end_overlay();
  return true;
}

}  // namespace alphascope
