// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view: shows the picture, collects events of the mouse, and lays progress and notes over
// the picture. The renderer draws the molecule, and view_marks.cpp the marks.
#include <algorithm>
#include <cmath>

#include "core/complex/alpha_complex.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/explain/dimension_words.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/store/answer.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/read/file_format.hpp"
#include "ui/calls.hpp"
#include "ui/caption.hpp"
#include "ui/panels/complex/clip_panel.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/running_jobs.hpp"
#include "ui/panels/frame/view_marks.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sandbox/flat_view.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/view_problem.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

// Draws the scene's texture as an opaque picture. Its alpha channel reads as one, whatever is
// stored there.
void picture(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const auto texture =
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(ctx.state.viewport.texture));
  if (ctx.state.viewport.texture != 0 && ctx.state.has_molecule()) {
    draw->AddImage(texture, corner, end, {0, 1}, {1, 0});
    if (ctx.state.viewport.outdated) {
      draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene, 0.6f));
    }
  } else {
    draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene));
  }
}

void mouse(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ViewportInfo& v = ctx.state.viewport;
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("##view", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  record(ctx, "view");
  const bool beside_menu =
      ctx.state.context.open && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
  v.hovered = false;
  if (!ctx.state.has_molecule()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const bool on_view = ImGui::IsItemHovered();
  const bool hovered = on_view && !clip_handle_mouse(ctx, corner, on_view);
  v.hovered = hovered && !ImGui::IsAnyMouseDown();
  v.mouse_x = static_cast<int>(io.MousePos.x - corner.x);
  v.mouse_y = static_cast<int>(io.MousePos.y - corner.y);
  if (!v.under_mouse.empty()) tooltip(ctx, v.under_mouse.c_str());
  bool& dragging = ctx.state.mouse.dragging_view;
  const auto event = [&](PointerEvent::Kind kind, int button, double wheel) {
    v.events.push_back({kind, static_cast<int>(io.MousePos.x - corner.x),
                        static_cast<int>(io.MousePos.y - corner.y), button, wheel, io.KeyCtrl,
                        io.KeyShift});
  };
  if (dragging && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    event(PointerEvent::Kind::move, 0, 0);
  }
  bool any_down = false;
  for (int b = 0; b < 3; ++b) {
    // A press of the right button closes a menu opened elsewhere, and its release opens the menu
    // here.
    if ((hovered || (beside_menu && b == 1)) && ImGui::IsMouseClicked(b)) {
      event(PointerEvent::Kind::move, b, 0);
      event(PointerEvent::Kind::press, b, 0);
      dragging = true;
    } else if (dragging && ImGui::IsMouseReleased(b)) {
      event(PointerEvent::Kind::release, b, 0);
      // A hand that trembles moves less than this; farther, it was a drag.
      const float reach = ctx.px(4);
      if (b != 2 && io.MouseDragMaxDistanceSqr[b] <= reach * reach) {
        event(PointerEvent::Kind::click, b, 0);
      }
    }
    any_down = any_down || ImGui::IsMouseDown(b);
  }
  if (!any_down) dragging = false;
  if (hovered && io.MouseWheel != 0) event(PointerEvent::Kind::wheel, 0, io.MouseWheel);
}

void caption(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  if (!ctx.state.result) return;
  const ViewState& s = ctx.state;
  const std::string text = caption_text(*s.result);
  // At the right there must be room for progress.
  const float room = size.x - ctx.px(s.jobs.empty() ? 32 : 260);
  ImVec2 place{corner.x + ctx.px(16), corner.y + ctx.px(14)};
  for (const std::string& line : {text, s.pending}) {
    const std::string fitted = fitted_text(line, room);
    draw_rim(ctx, place, fitted);
    ImGui::GetWindowDrawList()->AddText(place, to_u32(ctx.palette.text_muted), fitted.c_str());
    place.y += ImGui::GetTextLineHeightWithSpacing();
  }
}

// Says that atoms are hidden, since the picture lacks them. The note is below the caption and the
// pending complex, and below `top` (pixels of the view). Returns the y of its lower end.
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

// Explains a view that shows nothing, which would look broken. Placed below `top`, pixels of the
// view.
void problem(PanelContext& ctx, ImVec2 corner, ImVec2 size, float top) {
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

// Names the opened one of several dropped files, above the legends.
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

void empty_state(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
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

// Says that the selection left no atom. Returns whether it does.
bool nothing_left(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const MoleculeInfo& m = ctx.state.molecule;
  if (!m.loaded || m.balls > 0 || awaited_job(ctx.state.jobs) != nullptr) return false;
  begin_overlay(ctx, "##nothing", {corner.x + size.x / 2, corner.y + size.y / 2}, {0.5f, 0.5f});
  ImGui::TextUnformatted("The selection has no atoms, so there is nothing to show.");
  muted_text(ctx, "Keep more kinds of atoms or chains at the left, or clear the expression.");
  record(ctx, "view.nothing");
  end_overlay();
  return true;
}

// Says below the caption that the picture belongs to older settings.
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

// Shows why alpha has no complex, in the place of outdated_note(). The two never meet, since an
// older picture means that a newer computation runs. Returns the y of its lower end, pixels of the
// view.
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

}  // namespace

std::string caption_text(const Answer& answer) {
  CaptionParts parts = usual_caption();
  parts.set(CaptionPart::counts, false);  // counts are in the status bar
  const AlphaComplex& c = answer.complex;
  std::string text;
  for (const std::string& word : caption_words(answer, *answer.molecule, {}, parts)) {
    text += (text.empty() ? "" : kCaptionGap) + word;
  }
  if (c.tetrahedra.size() > 0 || answer.balls->size() == 0) return text;
  if (!c.tetrahedra_only && c.vertices.size() == 0) {
    return text + "   no ball is left at this alpha";
  }
  const int dimension = dimension_of_centres(*answer.balls);
  if (dimension == 3) return text + "   no tetrahedra at this alpha";
  return text + "   balls " + lie_text(dimension);  // so there are none at any alpha
}

std::string hidden_text(std::size_t atoms) {
  return with_separators(static_cast<long long>(atoms)) + (atoms == 1 ? " atom" : " atoms") +
         " hidden";
}

void draw_viewport(PanelContext& ctx) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  ViewportInfo& v = ctx.state.viewport;
  v.width = static_cast<int>(size.x);
  v.height = static_cast<int>(size.y);
  v.events.clear();
  if (v.width < 8 || v.height < 8) return;
  const bool flat = shows_flat_drawing(ctx.state);
  v.covered = flat;
  if (flat) {
    draw_flat_view(ctx, corner, size);
  } else {
    picture(ctx, corner, size);
    mouse(ctx, corner, size);
  }
  float legends_height = 0, top = 0;
  if (ctx.state.has_molecule()) {
    legends_height = draw_view_marks(ctx, corner, size);
    caption(ctx, corner, size);
    outdated_note(ctx, corner);
    top = hidden_note(ctx, corner, compute_error_note(ctx, corner, size));
  }
  draw_running_jobs(ctx, {corner.x + size.x - ctx.px(14), corner.y + ctx.px(12)});
  if (!flat) problem(ctx, corner, size, top);
  drop_note(ctx, corner, size, legends_height);
  empty_state(ctx, corner, size);
  // Without atoms, a note about things not drawn would say nothing.
  if (!nothing_left(ctx, corner, size)) not_drawn_note(ctx, corner, size, legends_height);
  draw_context_menu(ctx);
}

}  // namespace alphascope
