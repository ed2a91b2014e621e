// SPDX-License-Identifier: GPL-3.0-or-later
// The sections “Display” and “Light”: which parts of the complex are drawn, and how.
#include <algorithm>
#include <string>

#include "core/document/picture/picture_preset.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/complex/display_rows.hpp"
#include "ui/panels/complex/paint_rows.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/rgb8.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

using D = DisplaySettings;

void presets(PanelContext& ctx) {
  DisplaySettings& d = ctx.state.settings.display;
  const float gap = ctx.px(2);
  const float count =
      static_cast<float>(std::count_if(kDisplayPresets.begin(), kDisplayPresets.end(),
                                       [](DisplayPreset preset) { return !is_for_use(preset); }));
  const float each = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  for (const DisplayPreset preset : kDisplayPresets) {
    if (is_for_use(preset)) continue;  // in the dialog that saves pictures
    if (preset != kDisplayPresets.front()) ImGui::SameLine(0, gap);
    const DisplayPresetInfo& info = preset_info(preset);
    const bool on = d == with_preset(d, preset);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(ctx.palette.accent, 0.30f));
    if (button(ctx, (std::string("display.preset.") + info.id).c_str(), info.title, {each, 0})) {
      d = with_preset(d, preset);
    }
    if (on) ImGui::PopStyleColor();
    tooltip(ctx, (std::string(info.help) + ".").c_str());
  }
}

// Draws the slider for opacity. If a page fades balls and simplices, a note says that they are
// paler.
void opacity_row(PanelContext& ctx, DisplayField::Member member) {
  const DisplayField& field = display_field(member);
  display_row(ctx, field);
  const double opacity = number_of(field, ctx.state.settings.display);
  if (shown_opacity(ctx, opacity) == opacity) return;
  row_label(ctx, "");
  fading_note(ctx, control_name(field) + ".faded");
}

void balls(PanelContext& ctx) {
  DisplaySettings& d = ctx.state.settings.display;
  display_row(ctx, &D::balls);
  // Rows that do not apply are greyed, not hidden, so that nothing below moves.
  ImGui::BeginDisabled(!d.balls);
  ImGui::Indent();
  display_row(ctx, &D::ball_scale);
  const DisplayField& grown_balls = display_field(&D::grown_balls);
  row_label(ctx, grown_balls.label);
  int grown = d.grown_balls ? 1 : 0;
  choice(ctx, control_name(grown_balls).c_str(), {"as given", "grown"}, grown,
         ImGui::GetContentRegionAvail().x);
  d.grown_balls = grown == 1;
  opacity_row(ctx, &D::ball_opacity);
  constexpr Element kCarbon = 6;
  paint_rows(
      ctx,
      {"display.ball", PaintTarget::balls, ctx.state.viewport.ball_range, element_colour(kCarbon)},
      d.ball_paint);
  ImGui::Unindent();
  ImGui::EndDisabled();
}

// Draws the rows of triangles and edges, which “Tetrahedra only” does not compute.
void triangles_and_edges(PanelContext& ctx) {
  const DisplaySettings& d = ctx.state.settings.display;
  const bool only_tetrahedra = ctx.state.shows_tetrahedra_only();
  ImGui::BeginDisabled(only_tetrahedra);
  display_row(ctx, &D::triangles);
  ImGui::SameLine(0, ctx.px(18));
  display_row(ctx, &D::edges);
  ImGui::Indent();
  const bool applies = d.triangles || d.edges;
  ImGui::BeginDisabled(!applies);
  // The note takes the place of the check box, which has no effect then.
  if (only_tetrahedra && applies) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "Not computed, because “Tetrahedra only” is on.");
    record(ctx, "display.not_computed");
  } else {
    display_row(ctx, &D::singular_only);
  }
  ImGui::EndDisabled();
  ImGui::BeginDisabled(!d.edges);
  display_row(ctx, &D::edge_thickness);
  ImGui::EndDisabled();
  ImGui::Unindent();
  ImGui::EndDisabled();
}

void complex(PanelContext& ctx) {
  DisplaySettings& d = ctx.state.settings.display;
  display_row(ctx, &D::tetrahedra);
  ImGui::BeginDisabled(!d.tetrahedra);
  ImGui::Indent();
  display_row(ctx, &D::shrink);
  ImGui::Unindent();
  ImGui::EndDisabled();
  display_row(ctx, &D::boundary);
  ImGui::SameLine(0, ctx.px(18));
  ImGui::BeginDisabled(!d.boundary);
  display_row(ctx, &D::smooth_boundary);
  ImGui::EndDisabled();
  triangles_and_edges(ctx);
  opacity_row(ctx, &D::complex_opacity);
  paint_rows(ctx,
             {"display.complex", PaintTarget::simplices, ctx.state.viewport.simplex_range,
              to_rgb8(ctx.palette.complex_single)},
             d.complex_paint);
}

// Check boxes for atoms that the selection leaves out of the body. Kinds without such atoms are
// greyed.
void beside_body(PanelContext& ctx) {
  AtomsBesideBody& shown = ctx.state.settings.display.beside;
  const SelectionReport* report =
      ctx.state.references ? &ctx.state.references->prepared().report : nullptr;
  const std::size_t left_out[] = {
      report ? report->dropped_ligands : 0, report ? report->dropped_ions : 0,
      report ? report->dropped_waters : 0,
      report ? report->dropped_hydrogens + report->dropped_water_hydrogens : 0};
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const float left = ImGui::GetCursorPosX();
  muted_text(ctx, "Left out of the body, drawn beside it");
  ImGui::Indent();
  for (std::size_t n = 0; n < std::size(kBesideKinds); ++n) {
    const BesideKind& kind = kBesideKinds[n];
    if (n % 2 == 1) ImGui::SameLine(left + half);
    ImGui::BeginDisabled(left_out[n] == 0);
    checkbox(ctx, (std::string("display.beside.") + kind.id).c_str(), kind.title,
             shown.*kind.member);
    ImGui::EndDisabled();
    const std::string text = left_out[n] == 0
                                 ? "No such atom is left out of the body."
                                 : with_separators(static_cast<long long>(left_out[n])) +
                                       " atoms that are no part of the body. They are drawn, not "
                                       "computed: small balls in the colours of elements.";
    tooltip(ctx, text.c_str());
  }
  ImGui::Unindent();
}

void draw_display(PanelContext& ctx) {
  if (!section(ctx, "display", "Display")) return;
  presets(ctx);
  balls(ctx);
  complex(ctx);
  beside_body(ctx);
}

}  // namespace

std::unique_ptr<Panel> display_panel() {
  return panel_of(draw_display);
}

namespace {

void draw_look(PanelContext& ctx) {
  if (!section(ctx, "look", "Light")) return;
  for (const DisplayField& field : display_fields()) {
    if (field.group == DisplayGroup::light) display_row(ctx, field);
  }
}

}  // namespace

std::unique_ptr<Panel> look_panel() {
  return panel_of(draw_look);
}

}  // namespace alphascope
