// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Sandbox”: presets, options of the flat drawing, and a table of the balls. Every number
// in the table can be typed.
#include <algorithm>

#include "core/chart/flat_drawing.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/explain/dimension_words.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/answer.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/sandbox.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr NumberRule kSnapRule{"The step", 0, 10, "Å"};

void presets(PanelContext& ctx) {
  const CommandSpec* const spec = ctx.commands.find("sandbox.new");
  if (spec == nullptr) return;
  ImGui::SetNextItemWidth(ctx.px(150));
  if (list_field(ctx, "sandbox.preset", "New from preset")) {
    for (const Choice& preset : spec->parameters.front().choices()) {
      const std::string name = "sandbox.preset." + preset.id;
      if (ImGui::Selectable(preset.title.c_str())) ctx.commands.run("sandbox.new", {preset.id});
      record(ctx, name.c_str());
      tooltip(ctx, preset.detail.c_str());
    }
    ImGui::EndCombo();
  }
  record(ctx, "sandbox.preset");
  tooltip(ctx, "Opens an example of a few balls that you can change.");
}

void begin_row(PanelContext& ctx) {
  presets(ctx);
  same_line_where_it_fits(checkbox_width("Balls by hand"), ctx.px(8));
  const std::string why = why_not_editable(ctx.state);
  ImGui::BeginDisabled(!why.empty());
  bool by_hand = ctx.state.settings.open.sandbox.has_value();
  if (checkbox(ctx, "sandbox.by_hand", "Balls by hand", by_hand)) {
    ctx.commands.run("sandbox.by_hand", {by_hand ? "on" : "off"});
  }
  ImGui::EndDisabled();
  tooltip(ctx, why.empty() ? "On: the balls on screen can be moved, resized, added and removed. "
                             "Off: the balls are the file's again. Undo brings them back."
                           : why.c_str());
  if (!ctx.state.settings.open.sandbox) return;
  same_line_where_it_fits(button_width("Save…"), ctx.px(16));
  if (button(ctx, "sandbox.save", "Save…")) ctx.commands.run("file.export");
  tooltip(ctx, "Saves the flat drawing (.svg), the balls (.xyzr) or any other export format.");
  if (!shows_flat_drawing(ctx.state)) return;
  same_line_where_it_fits(button_width("Show all"), ctx.px(6));
  if (button(ctx, "sandbox.fit", "Show all")) ctx.state.sandbox.pixels_per_angstrom = 0;
}

void edit_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  SandboxState& m = s.sandbox;
  if (button(ctx, "sandbox.add", "Add a ball")) {
    const FlatPoint middle = m.pixels_per_angstrom > 0 ? m.middle : FlatPoint{};
    ctx.commands.run("sandbox.add", {shortest_number(snapped(middle[0], m.snap_angstrom)),
                                     shortest_number(snapped(middle[1], m.snap_angstrom)), "0"});
  }
  tooltip(
      ctx,
      "Adds a ball in the middle of the drawing. A double-click in the drawing adds one there.");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::BeginDisabled(selected_balls(s).empty());
  if (button(ctx, "sandbox.remove", "Remove")) remove_selected_balls(s);
  ImGui::EndDisabled();
  tooltip(ctx, "Removes the selected balls (Delete).");
  same_line_where_it_fits(checkbox_width("In a plane"), ctx.px(16));
  bool flat = s.settings.open.sandbox->flat;
  if (checkbox(ctx, "sandbox.flat", "In a plane", flat)) {
    ctx.commands.run("sandbox.flat", {flat ? "on" : "off"});
  }
  tooltip(ctx,
          "Moves every centre to z = 0 and keeps it there. The largest simplices are then "
          "triangles.");
  same_line_where_it_fits(checkbox_width("Flat drawing"), ctx.px(10));
  ImGui::BeginDisabled(!flat);
  checkbox(ctx, "sandbox.drawing", "Flat drawing", m.drawing);
  ImGui::EndDisabled();
  tooltip(ctx, "Replaces the 3-D picture by a flat drawing of circles, power diagram and complex.");
}

void drawing_row(PanelContext& ctx) {
  SandboxState& m = ctx.state.sandbox;
  const float gap = ctx.px(10), field = ctx.px(64);
  same_line_where_it_fits(checkbox_width("Grown discs"), gap);
  checkbox(ctx, "sandbox.discs", "Grown discs", m.content.discs);
  tooltip(ctx, "Each ball with the radius √(r² + α).");
  same_line_where_it_fits(checkbox_width("Power diagram"), gap);
  checkbox(ctx, "sandbox.cells", "Power diagram", m.content.cells);
  tooltip(ctx,
          "The cell of a ball is the set of points nearest to it by power distance |x − c|² − r². "
          "Cells do not depend on α.");
  same_line_where_it_fits(checkbox_width("Complex"), gap);
  checkbox(ctx, "sandbox.complex", "Complex", m.content.complex);
  tooltip(ctx,
          "The dual complex: green triangles, dark edges at their rim, yellow edges that belong "
          "to no triangle.");
  same_line_where_it_fits(ImGui::CalcTextSize("Step, Å").x + ctx.px(6) + field, ctx.px(16));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "Step, Å");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(field);
  number_field(ctx, "sandbox.snap", m.snap_angstrom, kSnapRule);
  tooltip(ctx,
          "Positions and radii set with the mouse are multiples of this step, in Å. So exact ties "
          "are possible. 0, or the key Alt, allows every position of the lattice.");
}

std::string counts_text(const ViewState& s) {
  return s.result ? with_minus_signs(own_counts_text(*s.result->balls, s.result->complex)) : "";
}

void coordinate(PanelContext& ctx, std::size_t ball, std::size_t axis) {
  Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  const double reach = sandbox_reach(sandbox.lattice);
  const NumberRule rule{"A coordinate", -reach, reach, "Å"};
  const std::string name = std::string("sandbox.") + "xyz"[axis] + "." + std::to_string(ball);
  SandboxPlace place = centre_of(sandbox, ball);
  ImGui::SetNextItemWidth(-1);
  if (number_field(ctx, name.c_str(), place[axis], rule)) move_ball(sandbox, ball, place);
}

void radius(PanelContext& ctx, std::size_t ball) {
  Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  const NumberRule rule{"A radius", least_sandbox_radius(sandbox.lattice),
                        most_sandbox_radius(sandbox.lattice), "Å"};
  double value = radius_of(sandbox, ball);
  ImGui::SetNextItemWidth(-1);
  const std::string name = "sandbox.r." + std::to_string(ball);
  if (number_field(ctx, name.c_str(), value, rule)) {
    resize_ball(sandbox, ball, value);
    ctx.state.sandbox.next_radius_angstrom = radius_of(sandbox, ball);
  }
}

void table(PanelContext& ctx) {
  ViewState& s = ctx.state;
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                     ImGuiTableFlags_BordersInnerH |
                                     ImGuiTableFlags_SizingStretchSame;
  const float width = std::min(ctx.px(560), ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginTable("balls", 5, kFlags, {width, 0})) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Ball", ImGuiTableColumnFlags_WidthFixed, ctx.px(64));
  for (const char* title : {"x, Å", "y, Å", "z, Å", "Radius, Å"}) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  const std::vector<BallIndex> chosen = selected_balls(s);
  for (std::size_t i = 0; i < s.settings.open.sandbox->balls.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const bool is_chosen = std::binary_search(chosen.begin(), chosen.end(), i);
    if (ImGui::Selectable(std::to_string(i + 1).c_str(), is_chosen)) {
      select_ball(s, i, ImGui::GetIO().KeyCtrl);
    }
    record(ctx, ("sandbox.ball." + std::to_string(i)).c_str());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ImGui::TableNextColumn();
      ImGui::BeginDisabled(axis == 2 && s.settings.open.sandbox->flat);
      coordinate(ctx, i, axis);
      ImGui::EndDisabled();
    }
    ImGui::TableNextColumn();
    radius(ctx, i);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void draw_sandbox(PanelContext& ctx) {
  begin_row(ctx);
  ViewState& s = ctx.state;
  if (!s.settings.open.sandbox) {
    muted_wrapped(ctx,
                  "Move a few balls by hand, and watch power diagram and complex change. Open "
                  "a preset, or switch “Balls by hand” on.");
    return;
  }
  edit_row(ctx);
  if (s.settings.open.sandbox->flat) drawing_row(ctx);
  if (!shows_flat_drawing(s)) {
    muted_text(ctx,
               "In the picture: drag a ball to move it; Ctrl+wheel over it resizes it. Hold "
               "Alt to ignore the step.");
  }
  const std::string counts = counts_text(s);
  if (!counts.empty()) {
    muted_text(ctx, counts);
    record(ctx, "sandbox.counts");
  }
  table(ctx);
}

}  // namespace

std::unique_ptr<Panel> sandbox_panel() {
  return panel_of(draw_sandbox);
}

}  // namespace alphascope
