// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the radii set, and the list of atoms without a radius in it. The user can type a
// radius for each row of the list.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "core/document/commands/commands.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/radius_edits.hpp"
#include "core/radii/radii_set.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/molecule/molecule_state.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

using Kind = RadiusRow::Kind;

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// Returns the source of a radii set, to help users choose.
std::string source_text(const RadiiSetInfo& info) {
  if (info.set == RadiiSet::automatic) {
    return "The file's own radii when it has any; else ProtOr for proteins and nucleic acids "
           "without hydrogens; else Bondi.";
  }
  if (info.set == RadiiSet::amber) {
    return "Half the distance at which two atoms of one type have their least van der Waals energy "
           "in AMBER's force fields; hydrogens too.\n" +
           std::string(info.citation);
  }
  return std::string(info.citation);
}

void set_entry(PanelContext& ctx, const RadiiSetInfo& info) {
  ViewState& s = ctx.state;
  const bool on = info.set == s.settings.open.balls.radii;
  const bool table = info.set == RadiiSet::user;
  const bool usable = info.set != RadiiSet::file || s.molecule.has_file_radii || on;
  const std::string label = std::string(info.name) + (table ? "…" : "");
  if (ImGui::Selectable(label.c_str(), on, usable ? 0 : ImGuiSelectableFlags_Disabled)) {
    if (table) {
      open_browser(s, BrowserPurpose::radii_table);
    } else {
      s.settings.open.balls.radii = info.set;
    }
  }
  record(ctx, ("molecule.radii." + std::string(info.id)).c_str());
  constexpr const char* kOwnTable =
      "Your own table, from a file with lines such as\nC 1.70\nALA CB 1.88\n* CB 1.88";
  const std::string help = !usable ? "This file has no radii of its own."
                           : table ? kOwnTable
                                   : source_text(info);
  tooltip(ctx, help.c_str());
}

void set_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  row_label(ctx, "Radii");
  const RadiiSetInfo& chosen = radii_set_info(s.settings.open.balls.radii);
  std::string preview(chosen.name);
  if (chosen.set == RadiiSet::automatic && !s.molecule.radii_name.empty()) {
    preview += ": " + s.molecule.radii_name;
  }
  const bool open = list_field(ctx, "molecule.radii", preview.c_str(), ImGuiComboFlags_HeightLarge);
  if (!open) {
    const std::string& citation = s.molecule.radii_citation;
    const std::string source =
        chosen.set == RadiiSet::user
            ? s.settings.open.radii_table.string() + "\nChoose this again to open another table."
        : citation.empty() ? source_text(chosen)
                           : citation;
    tooltip(ctx, source.c_str());
  } else {
    for (const RadiiSetInfo& info : all_radii_sets()) set_entry(ctx, info);
    ImGui::EndCombo();
  }
}

// --- list of radii

std::string title(const std::vector<RadiusRow>& rows) {
  std::size_t guessed = 0, by_hand = 0, none = 0;
  for (const RadiusRow& row : rows) {
    (row.kind == Kind::guessed   ? guessed
     : row.kind == Kind::by_hand ? by_hand
                                 : none) += row.radius.count;
  }
  std::string text;
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + number(count) + " " + what;
  };
  add(none, "without radius");
  add(guessed, "guessed");
  add(by_hand, "set by hand");
  return "Radii: " + text;
}

void apply(ViewState& s, MoleculeState& m, const RadiusRow& row, const std::string& text) {
  const NumberInput input = read_number(text, kBallRadiusRule);
  m.radius_error = input.error;
  if (input.value) set_radius(s.settings.open.balls.overrides, row.radius.group, *input.value);
}

void radius_field(PanelContext& ctx, MoleculeState& memory, const RadiusRow& row, int index) {
  ViewState& s = ctx.state;
  MoleculeState& m = memory;
  const std::string shown =
      row.kind == Kind::none ? "" : short_number_text(row.radius.radius_angstrom, 6);
  std::string text = m.radius_editing == index ? m.radius_typed : shown;
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##radius", "none", &text, ImGuiInputTextFlags_AutoSelectAll);
  const AtomGroup& atoms = row.radius.group;
  const std::string name = "radius." + atoms.residue + "." + atoms.atom;
  record(ctx, name.c_str());
  key_stop(ctx, name.c_str(), KeyStop::type);
  if (row.kind == Kind::guessed && !row.radius.source.empty()) {
    tooltip(ctx, ("Guessed: " + row.radius.source + ".").c_str());
  }
  if (ImGui::IsItemActivated()) {
    m.radius_editing = index;
    m.radius_error.clear();
  }
  if (m.radius_editing != index) return;
  m.radius_typed = text;
  if (ImGui::IsItemDeactivated()) {
    m.radius_editing = -1;
    if (text != shown) apply(s, memory, row, text);
  }
}

void radius_line(PanelContext& ctx, MoleculeState& memory, const RadiusRow& row, int index) {
  ViewState& s = ctx.state;
  const AtomGroup& atoms = row.radius.group;
  const std::string element(element_symbol(atoms.element));
  ImGui::PushID((atoms.residue + '\n' + atoms.atom + '\n' + element).c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const std::string name = atoms.residue + " " + atoms.atom;
  ImGui::TextUnformatted(name == " " ? "(no name)" : name.c_str());
  ImGui::TableNextColumn();
  const bool known = atoms.element != kUnknownElement;
  muted_text(ctx, known ? element : "?");
  if (!known) tooltip(ctx, "The element is not known.");
  ImGui::TableNextColumn();
  muted_text(ctx, number(row.radius.count));
  ImGui::TableNextColumn();
  radius_field(ctx, memory, row, index);
  ImGui::TableNextColumn();
  if (row.kind == Kind::by_hand) {
    const std::string id = "radius.reset." + atoms.residue + "." + atoms.atom;
    if (button(ctx, id.c_str(), "×", {-1, 0}, ButtonKind::quiet)) {
      reset_radius(s.settings.open.balls.overrides, atoms);
    }
    tooltip(ctx, "Set by hand. Reset to the radii set's value.");
  }
  ImGui::PopID();
}

void radius_table(PanelContext& ctx, MoleculeState& memory) {
  const auto& rows = ctx.state.molecule.radius_rows;
  const float row_height = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height = row_height * static_cast<float>(std::min<std::size_t>(rows.size(), 8) + 1);
  if (!ImGui::BeginTable("radii", 5, ImGuiTableFlags_ScrollY, {0, height})) return;
  ImGui::TableSetupColumn("Residue, atom", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("El.", ImGuiTableColumnFlags_WidthFixed, ctx.px(22));
  ImGui::TableSetupColumn("Atoms", ImGuiTableColumnFlags_WidthFixed, ctx.px(46));
  ImGui::TableSetupColumn("Radius, Å", ImGuiTableColumnFlags_WidthFixed, ctx.px(66));
  ImGui::TableSetupColumn("##reset", ImGuiTableColumnFlags_WidthFixed, ctx.px(22));
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  ImGui::TableHeadersRow();
  ImGui::PopStyleColor();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), row_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      radius_line(ctx, memory, rows[static_cast<std::size_t>(i)], i);
    }
  }
  ImGui::EndTable();
}

void radius_list(PanelContext& ctx, MoleculeState& memory) {
  ViewState& s = ctx.state;
  const auto& rows = s.molecule.radius_rows;
  const bool edited = !s.settings.open.balls.overrides.empty();
  if (rows.empty() && !edited) return nothing_to_disclose(ctx, "Radii: all from the radii set");
  const bool warn = std::any_of(rows.begin(), rows.end(),
                                [](const RadiusRow& row) { return row.kind != Kind::by_hand; });
  if (!disclosure(ctx, "molecule.radius_list", title(rows),
                  warn ? ctx.palette.warning : ctx.palette.text_muted)) {
    return;
  }
  ImGui::Unindent();  // the table needs the width
  ImGui::PushFont(ctx.fonts.small);
  muted_wrapped(
      ctx, "The radii set has no value for these atoms. Type a better radius if you know one.");
  if (!rows.empty()) radius_table(ctx, memory);
  const float top = ImGui::GetCursorPosY();
  if (!memory.radius_error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    wrapped_text(memory.radius_error);
    ImGui::PopStyleColor();
    record(ctx, "radius.error");
  }
  reserve_lines(top, 2);
  ImGui::BeginDisabled(!edited);
  if (button(ctx, "radius.reset_all", "Reset all radii set by hand")) {
    s.settings.open.balls.overrides.clear();
  }
  ImGui::EndDisabled();
  ImGui::PopFont();
  ImGui::Indent();
  ImGui::TreePop();
}

}  // namespace

void draw_radii_rows(PanelContext& ctx, MoleculeState& memory) {
  set_row(ctx);
  radius_list(ctx, memory);
}

}  // namespace alphascope
