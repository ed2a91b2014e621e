// SPDX-License-Identifier: GPL-3.0-or-later
// Notes over the 3-D view: why the picture lacks something, is old, or shows nothing.
#include <algorithm>
#include <string>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/clip.hpp"
#include "ui/calls.hpp"
#include "ui/panels/frame/overlay.hpp"
#include "ui/panels/frame/view_marks.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/running_job.hpp"
#include "ui/view_problem.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

float hidden_note(PanelContext& ctx, ImVec2 corner, float top) {
  const ViewState& s = ctx.state;
  const std::size_t hidden = s.viewport.hidden_balls;
  if (hidden == 0) return top;
  const float row = ImGui::GetTextLineHeightWithSpacing();
  const float y = std::max(ctx.px(12) + 2 * row, top);
  begin_overlay(ctx, "##hidden", {corner.x + ctx.px(10), corner.y + y}, {0, 0});
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(to_imgui(ctx.palette.warning), "%s", hidden_text(hidden).c_str());
  record(ctx, "view.hidden");
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "view.show_hidden", "Show all")) ctx.commands.run("atoms.show_all");
  const float height = ImGui::GetWindowHeight();
  end_overlay();
  return y + height + ctx.px(6);
}

void view_problem_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float top) {
  const ViewportInfo& v = ctx.state.viewport;
  if (v.problem == ViewProblem::none || !ctx.state.has_molecule() || v.outdated) return;
  begin_overlay(ctx, "##trouble", {corner.x + size.x / 2, corner.y + std::max(ctx.px(44), top)},
                {0.5f, 0});
  ImGui::AlignTextToFramePadding();
  const bool cut_away = v.problem == ViewProblem::cut_away;
  const bool all_hidden = v.problem == ViewProblem::all_hidden;
  ImGui::TextUnformatted(all_hidden ? "All atoms are hidden."
                         : cut_away ? "The clip cuts everything away."
                         : v.problem == ViewProblem::inside_a_ball
                             ? "The camera is inside a ball."
                             : "The molecule is out of view.");
  record(ctx, "view.trouble");
  ImGui::SameLine();
  if (all_hidden) {
    const CommandSpec* const show = ctx.commands.find("atoms.show_all");
    if (button(ctx, "view.show_hidden", "Show all atoms") && show) run_command(ctx, *show, {});
    return end_overlay();
  }
  if (cut_away) {
    if (button(ctx, "view.no_clip", "No clip (K)")) ctx.state.settings.clip.kind = Clip::Kind::off;
    return end_overlay();
  }
  if (button(ctx, "view.show_all", "Show all (R)")) ctx.calls.view.reset();
  end_overlay();
}

void drop_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float legends_height) {
  std::string& note = ctx.state.drop_note;
  if (note.empty()) return;
  begin_overlay(ctx, "##dropped",
                {corner.x + ctx.px(14), corner.y + size.y - ctx.px(14) - legends_height}, {0, 1});
  ImGui::TextUnformatted(note.c_str());
  record(ctx, "view.dropped");
  if (button(ctx, "view.dropped.ok", "OK", {ctx.px(80), 0})) note.clear();
  end_overlay();
}

void outdated_note(PanelContext& ctx, ImVec2 corner) {
  if (!ctx.state.viewport.outdated) return;
  const float below = ctx.px(18) + ImGui::GetTextLineHeight();
  const char* const text =
      "This complex belongs to the previous settings. The new one is not ready yet.";
  ImGui::SetCursorScreenPos({corner.x + ctx.px(16), corner.y + below});
  draw_rim(ctx, ImGui::GetCursorScreenPos(), text);
  ImGui::TextColored(to_imgui(ctx.palette.warning), "%s", text);
  record(ctx, "view.outdated");
}

float compute_error_note(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const ViewState& s = ctx.state;
  const float top = ctx.px(18) + ImGui::GetTextLineHeight();
  if (s.compute_error.empty() || awaited_job(s.jobs) != nullptr || s.viewport.outdated) return 0;
  ImGui::SetCursorScreenPos({corner.x + ctx.px(16), corner.y + top});
  const std::string text = broken_lines(s.compute_error, size.x - ctx.px(32));
  draw_rim(ctx, ImGui::GetCursorScreenPos(), text);
  ImGui::TextColored(to_imgui(ctx.palette.error), "%s", text.c_str());
  record(ctx, "view.compute_error");
  return top + ImGui::GetItemRectSize().y + ctx.px(6);
}

void not_drawn_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float legends_height) {
  const ViewportInfo& v = ctx.state.viewport;
  if (v.not_drawn.empty() || !ctx.state.has_molecule() || v.outdated) return;
  // The note is between legend and scale bar if it has room there, else above both.
  const float between = size.x - ctx.px(600);
  const bool above = between < ctx.px(300), empty = !(v.angstrom_per_pixel > 0);
  const float width = above ? size.x - ctx.px(56) : std::min(between, ctx.px(640));
  const float y =
      empty ? size.y / 2
            : size.y - (above ? std::max(ctx.px(76), legends_height + ctx.px(8)) : ctx.px(14));
  begin_overlay(ctx, "##not_drawn", {corner.x + size.x / 2, corner.y + y},
                {0.5f, empty ? 0.5f : 1.0f});
  ImGui::PushTextWrapPos(width);
  ImGui::TextColored(to_imgui(ctx.palette.warning), "%s", v.not_drawn.c_str());
  const ViewState& s = ctx.state;
  if (s.result && s.compute_error.empty()) {
    ImGui::TextUnformatted("All numbers and exports are complete.");
    record(ctx, "view.numbers_complete");
  }
  ImGui::PopTextWrapPos();
  record(ctx, "view.not_drawn");
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

std::string hidden_text(std::size_t atoms) {
  return with_separators(static_cast<long long>(atoms)) + (atoms == 1 ? " atom" : " atoms") +
         " hidden";
}

}  // namespace alphascope
