// The sections “Display” and “Light”: which parts of the complex are drawn, and how.
#include <cmath>
#include <string>

#include "core/document/session/settings_fields.hpp"
#include "core/document/settings/display_preset.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/complex/paint_rows.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/rgb8.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

void presets(PanelContext& ctx) {
  DisplayControls& d = ctx.state.settings.display;
  const float gap = ctx.px(2);
  const float count = static_cast<float>(kDisplayPresets.size());
  const float each = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  for (const DisplayPreset preset : kDisplayPresets) {
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
void opacity_row(PanelContext& ctx, const char* name, float& opacity) {
  row_label(ctx, "Opacity");
  percent_slider(ctx, name, opacity, 0.05f, 1.0f);
  if (!ctx.state.viewport.fades_rest || opacity <= kFadedOpacity) return;
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, "faded to " + percent_text(kFadedOpacity) + " by the page below");
  ImGui::PopFont();
  record(ctx, (std::string(name) + ".faded").c_str());
  tooltip(ctx,
          "A cavity or channel is drawn, and what is around it must not hide it. For cavities: "
          "the page Cavities, Draw, “fade the rest”.");
}

void balls(PanelContext& ctx) {
  DisplayControls& d = ctx.state.settings.display;
  checkbox(ctx, "display.balls", "Balls", d.balls);
  // Rows that do not apply are greyed, not hidden, so that nothing below moves.
  ImGui::BeginDisabled(!d.balls);
  ImGui::Indent();
  row_label(ctx, "Size");
  percent_slider(ctx, "display.ball_scale", d.ball_scale, 0.05f, 1.0f);
  row_label(ctx, "Radius");
  int grown = d.grown_balls ? 1 : 0;
  choice(ctx, "display.radius", {"as given", "grown"}, grown, ImGui::GetContentRegionAvail().x);
  d.grown_balls = grown == 1;
  opacity_row(ctx, "display.ball_opacity", d.ball_opacity);
  constexpr Element kCarbon = 6;
  paint_rows(
      ctx, {"display.ball", Painted::balls, ctx.state.viewport.ball_range, element_colour(kCarbon)},
      d.ball_paint);
  ImGui::Unindent();
  ImGui::EndDisabled();
}

void thickness_of_edges(PanelContext& ctx) {
  DisplayControls& d = ctx.state.settings.display;
  ImGui::BeginDisabled(!d.edges);
  row_label(ctx, "Thickness");
  double thickness = d.edge_thickness;
  if (value_slider(ctx, "display.edge_thickness", thickness, 0.02, 0.6, kEdgeThicknessRule,
                   number_text(thickness, 2) + " Å")) {
    d.edge_thickness = static_cast<float>(std::round(thickness * 50) / 50);
  }
  tooltip(ctx, "Of edges, in the picture. Far away they are at least as thick as a line.");
  ImGui::EndDisabled();
}

void complex(PanelContext& ctx) {
  DisplayControls& d = ctx.state.settings.display;
  const bool only_tetrahedra = ctx.state.result && ctx.state.result->complex.tetrahedra_only;
  checkbox(ctx, "display.tetrahedra", "Tetrahedra", d.tetrahedra);
  ImGui::BeginDisabled(!d.tetrahedra);
  ImGui::Indent();
  row_label(ctx, "Shrink");
  percent_slider(ctx, "display.shrink", d.shrink, 0.0f, 0.9f);
  ImGui::Unindent();
  ImGui::EndDisabled();
  checkbox(ctx, "display.boundary", "Boundary surface", d.boundary);
  tooltip(ctx, "Faces that belong to exactly one tetrahedron.");
  ImGui::SameLine(0, ctx.px(18));
  ImGui::BeginDisabled(!d.boundary);
  checkbox(ctx, "display.smooth_boundary", "Smooth", d.smooth_boundary);
  tooltip(ctx, "Lights the boundary as if it were round between its corners. Its shape stays.");
  ImGui::EndDisabled();
  ImGui::BeginDisabled(only_tetrahedra);
  checkbox(ctx, "display.triangles", "Triangles", d.triangles);
  ImGui::SameLine(0, ctx.px(18));
  checkbox(ctx, "display.edges", "Edges", d.edges);
  ImGui::Indent();
  const bool applies = d.triangles || d.edges;
  ImGui::BeginDisabled(!applies);
  // The note takes the place of the check box, which has no effect then.
  if (only_tetrahedra && applies) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "Not computed, because “Tetrahedra only” is on.");
    record(ctx, "display.not_computed");
  } else {
    checkbox(ctx, "display.singular_only", "Singular ones only", d.singular_only);
    tooltip(ctx, "Singular: not a face of any larger simplex of the complex.");
  }
  ImGui::EndDisabled();
  thickness_of_edges(ctx);
  ImGui::Unindent();
  ImGui::EndDisabled();
  opacity_row(ctx, "display.complex_opacity", d.complex_opacity);
  paint_rows(ctx,
             {"display.complex", Painted::simplices, ctx.state.viewport.simplex_range,
              to_rgb8(ctx.palette.complex_single)},
             d.complex_paint);
}

// Check boxes for atoms that the selection leaves out of the body. Kinds without such atoms are
// greyed.
void beside_body(PanelContext& ctx) {
  AtomsBesideBody& shown = ctx.state.settings.display.beside;
  const SelectionReport* report =
      ctx.state.references ? &ctx.state.references->prepared().report : nullptr;
  const auto kind = [&](const char* name, const char* label, std::size_t atoms, bool& value) {
    ImGui::BeginDisabled(atoms == 0);
    checkbox(ctx, name, label, value);
    ImGui::EndDisabled();
    const std::string text =
        atoms == 0 ? "None is left out of the body."
                   : with_separators(static_cast<long long>(atoms)) +
                         " atoms that are no part of the body. They are drawn, not computed: "
                         "small balls in the colours of elements.";
    tooltip(ctx, text.c_str());
  };
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const float left = ImGui::GetCursorPosX();
  muted_text(ctx, "Left out of the body, drawn beside it");
  ImGui::Indent();
  kind("display.beside.ligands", "Ligands", report ? report->dropped_ligands : 0, shown.ligands);
  ImGui::SameLine(left + half);
  kind("display.beside.ions", "Ions", report ? report->dropped_ions : 0, shown.ions);
  kind("display.beside.waters", "Waters", report ? report->dropped_waters : 0, shown.waters);
  ImGui::SameLine(left + half);
  const std::size_t hydrogens =
      report ? report->dropped_hydrogens + report->dropped_water_hydrogens : 0;
  kind("display.beside.hydrogens", "Hydrogens", hydrogens, shown.hydrogens);
  ImGui::Unindent();
}

void draw_display(PanelContext& ctx) {
  if (!section(ctx, "display", "Display")) return;
  presets(ctx);
  balls(ctx);
  complex(ctx);
  beside_body(ctx);
  checkbox(ctx, "display.occlusion", "Soft shadows at rest",
           ctx.state.settings.display.ambient_occlusion);
  tooltip(ctx,
          "Crevices darken, and what is before the light casts a shadow. Left out while you turn a "
          "large molecule.");
}

}  // namespace

std::unique_ptr<Panel> display_panel() {
  return panel_of(draw_display);
}

namespace {

void draw_look(PanelContext& ctx) {
  if (!section(ctx, "look", "Light")) return;
  DisplayControls& d = ctx.state.settings.display;
  row_label(ctx, "Depth cue");
  percent_slider(ctx, "look.depth_cue", d.depth_cue, 0, 1);
  tooltip(ctx, "What is far away fades into the background by so much.");
  row_label(ctx, "Outlines");
  double width = d.silhouettes;
  if (value_slider(ctx, "look.silhouettes", width, 0, 4, kSilhouettesRule,
                   number_text(width, 1) + " px")) {
    d.silhouettes = static_cast<float>(std::round(width * 4) / 4);
  }
  tooltip(ctx, "Width of the dark lines where something is before something else; 0: none.");
  row_label(ctx, "Face lines");
  double sides = d.face_edges;
  if (value_slider(ctx, "look.face_edges", sides, 0, 4, kFaceEdgesRule,
                   number_text(sides, 1) + " px")) {
    d.face_edges = static_cast<float>(std::round(sides * 4) / 4);
  }
  tooltip(ctx,
          "Width of the darker lines between triangles, where these are large enough; 0: none.");
  row_label(ctx, "Samples");
  double samples = d.samples;
  if (value_slider(ctx, "look.samples", samples, 1, 16, kSamplesRule, std::to_string(d.samples))) {
    d.samples = static_cast<int>(std::lround(samples));
  }
  tooltip(ctx,
          "So many pictures are averaged at rest and in saved pictures: smooth edges and "
          "shadows.");
}

}  // namespace

std::unique_ptr<Panel> look_panel() {
  return panel_of(draw_look);
}

}  // namespace alphascope
