// SPDX-License-Identifier: GPL-3.0-or-later
// The list of residues: their kind and the reason for it, in the words of `info --residues`. The
// user can choose another kind for each line.
#include <imgui.h>

#include <algorithm>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/selection/residue_groups.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/molecule/molecule_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kLinesInSight = 4;

std::string residues_text(const ResidueGroup& group) {
  return counted(group.residues, "residue", "residues");
}

std::string count_text(const ResidueGroup& group) {
  return residues_text(group) + ", " + counted(group.atoms, "atom", "atoms");
}

// Returns the group's part of widgets' names: "HEM", or "HEM.2" for the second group of that name.
std::string widget_part(const ResidueGroup& group) {
  return group.nth == 1 ? group.name : group.name + "." + std::to_string(group.nth);
}

bool can_be_treated(const ResidueGroup& group) {
  return !group.called.empty() || !group.treated.empty();
}

std::string why_not_treated(const ResidueGroup& group) {
  if (group.why == ResidueReason::virtual_site) {
    return "Virtual sites keep their kind, whatever kind their residue has.";
  }
  return "Other residues have the same name. To set the kind of these alone, use --treat with an "
         "expression on the command line.";
}

void kind_entry(PanelContext& ctx, const ResidueGroup& group, ResidueKind kind) {
  const bool on = group.why == ResidueReason::by_hand && group.kind == kind;
  const auto flags = group.called.empty() ? ImGuiSelectableFlags_Disabled : 0;
  if (ImGui::Selectable(kind_name(kind), on, flags)) {
    set_group_kind(ctx.state.settings.open.balls.treated, group, kind);
  }
  record(ctx, (std::string("residue.as.") + kind_name(kind)).c_str());
}

void file_entry(PanelContext& ctx, const ResidueGroup& group) {
  const bool treated = !group.treated.empty();
  const std::string label = std::string("as the file says: ") + kind_name(group.file_kind);
  if (ImGui::Selectable(label.c_str(), !treated, treated ? 0 : ImGuiSelectableFlags_Disabled)) {
    remove_treatments(ctx.state.settings.open.balls.treated, group);
  }
  record(ctx, "residue.as.file");
  if (!treated) return;
  std::string help = "Removes the kind set by hand. The kind is then:";
  for (const std::string& text : group.treated) help += "\n" + text;
  tooltip(ctx, help.c_str());
}

void treat_as(PanelContext& ctx, const ResidueGroup& group, float width) {
  const std::string name = "residue." + widget_part(group);
  if (!can_be_treated(group)) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, kind_name(group.kind));
    record(ctx, name.c_str());
    return tooltip(ctx, why_not_treated(group).c_str());
  }
  ImGui::SetNextItemWidth(width);
  const bool open = list_field(ctx, name.c_str(), kind_name(group.kind));
  if (!open) return tooltip(ctx, "Sets the kind of these residues, whatever the file says.");
  file_entry(ctx, group);
  ImGui::Separator();
  for (const ResidueKind kind : {ResidueKind::polymer, ResidueKind::ligand, ResidueKind::ion,
                                 ResidueKind::water, ResidueKind::dummy}) {
    kind_entry(ctx, group, kind);
  }
  ImGui::EndCombo();
}

void name_cell(PanelContext& ctx, const ResidueGroup& group, float width) {
  const std::string shown =
      group.name.empty() ? "(no name)" : fitted_text(group.name, width - ctx.px(4));
  const std::string selects = selection_text(group);
  ImGui::AlignTextToFramePadding();
  if (is_guess(group.why)) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
  }
  const auto flags = selects.empty() ? ImGuiSelectableFlags_Disabled : 0;
  const bool clicked = ImGui::Selectable(shown.c_str(), false, flags, {width, 0});
  if (is_guess(group.why)) ImGui::PopStyleColor();
  record(ctx, ("residue.name." + widget_part(group)).c_str());
  if (selects.empty()) return;
  tooltip(ctx,
          (selects + "\nClick to select these atoms; press Z to move the view to them.").c_str());
  const CommandSpec* const select = ctx.commands.find("select.atoms");
  if (clicked && select != nullptr) run_command(ctx, *select, {selects});
}

void group_line(PanelContext& ctx, const ResidueGroup& group, int index) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float name = ctx.px(58), combo = ctx.px(86), gap = ctx.px(6);
  ImGui::PushID(index);
  name_cell(ctx, group, name);
  ImGui::SameLine(name + gap);
  ImGui::AlignTextToFramePadding();
  const std::string count = count_text(group);
  const float room = width - name - combo - 2 * gap;
  const bool fits = fitted_text(count, room) == count;
  muted_text(ctx, fits ? count : fitted_text(residues_text(group), room));
  tooltip(ctx, count.c_str());
  ImGui::SameLine(width - combo);
  treat_as(ctx, group, combo);
  const std::string why = why_text(group);
  ImGui::PushStyleColor(
      ImGuiCol_Text, to_imgui(is_guess(group.why) ? ctx.palette.warning : ctx.palette.text_muted));
  ImGui::TextUnformatted(fitted_text(why, width).c_str());
  ImGui::PopStyleColor();
  record(ctx, ("residue.why." + widget_part(group)).c_str());
  tooltip(ctx, why.c_str());
  ImGui::PopID();
}

// Draws the lines in sight only. Each is two lines of text high.
void group_lines(PanelContext& ctx, const std::vector<ResidueGroup>& groups) {
  const float line = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  const float height = line * static_cast<float>(std::min(groups.size(), kLinesInSight));
  ImGui::BeginChild("residues", {0, height});
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(groups.size()), line);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      group_line(ctx, groups[static_cast<std::size_t>(i)], i);
    }
  }
  ImGui::EndChild();
}

}  // namespace

void draw_residue_rows(PanelContext& ctx, MoleculeState& memory) {
  ViewState& s = ctx.state;
  const std::shared_ptr<const ResidueGroups> groups = s.molecule.residues;
  if (!groups || groups->of.empty()) return nothing_to_disclose(ctx, "Residues: none are known.");
  const std::string decisions = decisions_text(*groups), kinds = kinds_text(groups->kinds);
  // A new molecule's list opens if there are guesses to judge. Later it stays as the user leaves
  // it.
  if (memory.residues_of != s.molecule.sha256) {
    memory.residues_of = s.molecule.sha256;
    ImGui::SetNextItemOpen(groups->guessed > 0);
  }
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing();
  const bool open =
      disclosure(ctx, "molecule.residues", fitted_text("Residues: " + decisions, room),
                 groups->guessed > 0 ? ctx.palette.warning : ctx.palette.text_muted);
  tooltip(ctx, ("Residues of the present model: " + kinds).c_str());
  if (!open) return;
  ImGui::Unindent();  // the list needs the width
  ImGui::PushFont(ctx.fonts.small);
  if (kinds != decisions) muted_wrapped(ctx, kinds);  // else the line above has them
  group_lines(ctx, groups->of);
  ImGui::PopFont();
  ImGui::Indent();
  ImGui::TreePop();
}

}  // namespace alphascope
