// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of the right mouse button. It offers commands on the atom or simplex under the
// mouse, or on the whole view.
#include <imgui.h>

#include <cstdio>
#include <functional>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/run/cancel_token.hpp"
#include "core/selection/atom_address.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr float kTitleWidth = 300;  // pixels at scale 1

struct Entry {
  std::string name;  // name of the widget: "context.select"
  std::string label;
  std::string id = {};  // id of the command
  std::vector<std::string> words = {};
};

void entry(PanelContext& ctx, const Entry& e) {
  const CommandSpec* const spec = ctx.commands.find(e.id);
  const std::string reason = spec->reason_against();
  const bool clicked = ImGui::MenuItem(e.label.c_str(), nullptr, false, reason.empty());
  record(ctx, e.name.c_str());
  tooltip(ctx, (reason.empty() ? spec->help + "." : reason).c_str());
  if (clicked) run_command(ctx, *spec, e.words);
}

// Entries for the texts that a label of the thing can have, each beside its name.
void labels(PanelContext& ctx, const Ref& what, const std::string& atoms) {
  const CommandSpec* const spec = ctx.commands.find("label.atoms");
  for (const Choice& choice : spec->parameters.front().choices()) {
    std::string text;
    for (const auto& [value, id] : label_text_ids()) {
      if (id == choice.id) text = label_text(*ctx.state.references, what, value);
    }
    const bool any = !text.empty();
    const std::string shown = any ? fitted_text(text, ctx.px(kTitleWidth)) : "none";
    const bool clicked = ImGui::MenuItem(choice.title.c_str(), shown.c_str(), false, any);
    record(ctx, ("context.label." + choice.id).c_str());
    if (clicked) run_command(ctx, *spec, {choice.id, atoms});
  }
}

constexpr std::pair<const char*, const char*> kColours[] = {
    {"Red", "#e5484d"},    {"Orange", "#ff8c1a"}, {"Yellow", "#ffd43b"},
    {"Green", "#37b24d"},  {"Cyan", "#22b8cf"},   {"Blue", "#3b82f6"},
    {"Violet", "#9b5de5"}, {"White", "#f4f4f4"},  {"Grey", "#8a8f98"}};

void colours(PanelContext& ctx, const std::string& atoms) {
  for (const auto& [title, colour] : kColours) {
    unsigned rgb = 0;
    std::sscanf(colour, "#%x", &rgb);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetTextLineHeight() * 0.8f;
    const std::string label = "     " + std::string(title);
    if (ImGui::MenuItem(label.c_str())) {
      run_command(ctx, *ctx.commands.find("atoms.colour"), {colour, atoms});
    }
    record(ctx, ("context.colour." + std::string(title)).c_str());
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x, corner.y + ctx.px(2)}, {corner.x + size, corner.y + ctx.px(2) + size},
        IM_COL32(rgb >> 16, (rgb >> 8) & 0xff, rgb & 0xff, 0xff), ctx.px(2));
  }
  ImGui::Separator();
  entry(ctx, {"context.usual_colour", "Usual colour", "atoms.usual_colour", {atoms}});
}

void submenu(PanelContext& ctx, const char* name, const char* label,
             const std::function<void()>& content) {
  const bool open = ImGui::BeginMenu(label);
  record(ctx, name);
  if (!open) return;
  content();
  ImGui::EndMenu();
}

// Returns the label of the entry that measures. The number of selected atoms decides between
// distance, angle and dihedral angle.
const char* measure_label(const PanelContext& ctx, const Ref& what) {
  const Selection& picked = ctx.state.settings.selection;
  const std::size_t from = picked.items.size() - (picked.items.contains(what) ? 1 : 0);
  return from == 2   ? "Measure angle with selection"
         : from == 3 ? "Measure dihedral angle with selection"
                     : "Measure distance to selection";
}

void of_residue(PanelContext& ctx, const Molecule& molecule, const AtomRef& ref,
                const std::string& atoms) {
  const auto atom = find_atom(molecule, {ref.atom, ref.copy});
  if (!atom) return;
  const std::string chain(molecule.text(molecule.atoms[*atom].chain));
  entry(ctx, {"context.residue",
              "Select residue " + residue_within_chain(molecule, *atom),
              "select.atoms",
              {"byres (" + atoms + ")"}});
  entry(ctx, {"context.chain",
              chain.empty() ? "Select chain" : "Select chain " + chain,
              "select.atoms",
              {"bychain (" + atoms + ")"}});
}

// Entries that select the atom or simplex under the mouse.
void selecting(PanelContext& ctx, const Ref& what, const std::string& atoms) {
  const bool selected = ctx.state.settings.selection.items.contains(what);
  entry(ctx, {"context.select", "Select", "pointed.select"});
  entry(ctx,
        {"context.add", selected ? "Remove from selection" : "Add to selection", "pointed.toggle"});
  const AtomRef* const atom = std::get_if<AtomRef>(&what);
  if (atom != nullptr) of_residue(ctx, ctx.state.references->molecule(), *atom, atoms);
}

// `of_many`: an expression for more atoms than `what`; empty: none.
void of_something(PanelContext& ctx, const Ref& what, const std::string& title,
                  const std::string& of_many) {
  const bool many = !of_many.empty();
  const std::string one = expression_of(ctx.state.references->molecule(), what);
  const std::string& atoms = many ? of_many : one;
  strong_text(ctx, fitted_text(title, ctx.px(kTitleWidth)));
  record(ctx, "context.title");
  ImGui::Separator();
  if (many) {
    entry(ctx, {"context.select", "Select", "select.atoms", {atoms}});
    entry(ctx, {"context.add", "Add to selection", "select.add", {atoms}});
  } else {
    selecting(ctx, what, atoms);
  }
  ImGui::Separator();
  entry(ctx, {"context.zoom", "Zoom to", "view.zoom_to", {atoms}});
  entry(ctx, {"context.centre", "Centre rotation here", "view.centre", {atoms}});
  ImGui::Separator();
  submenu(ctx, "context.label", "Label", [&] {
    labels(ctx, what, one);
    ImGui::Separator();
    entry(ctx, {"context.no_label", "No label", "label.remove", {atoms}});
  });
  if (!many) entry(ctx, {"context.measure", measure_label(ctx, what), "pointed.measure"});
  ImGui::Separator();
  entry(ctx, {"context.hide", "Hide", "atoms.hide", {atoms}});
  entry(ctx, {"context.only", "Show only", "atoms.only", {atoms}});
  entry(ctx, {"context.show_all", "Show all", "atoms.show_all"});
  submenu(ctx, "context.colour", "Colour", [&] { colours(ctx, atoms); });
  if (many) return;
  ImGui::Separator();
  entry(ctx, {"context.why", "Why is this here?", "pointed.why"});
  entry(ctx, {"context.copy_name", "Copy name", "pointed.copy_name"});
}

void of_nothing(PanelContext& ctx) {
  entry(ctx, {"context.show_all", "Show all", "atoms.show_all"});
  entry(ctx, {"context.none", "Clear selection", "select.none"});
  entry(ctx, {"context.reset", "Reset view", "view.reset"});
  ImGui::Separator();
  entry(ctx, {"context.save", "Save picture…", "file.save_picture"});
}

}  // namespace

void draw_context_menu(PanelContext& ctx) {
  ContextState& menu = ctx.state.context;
  if (std::exchange(menu.opens, false)) ImGui::OpenPopup("##context");
  // The view has no padding, and its popups would inherit that.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ctx.px(10), ctx.px(8)});
  menu.open = ImGui::BeginPopup("##context");
  ImGui::PopStyleVar();
  if (!menu.open) return;
  close_on_escape();
  if (menu.what && ctx.state.references) {
    of_something(ctx, *menu.what, menu.title, menu.atoms);
  } else {
    of_nothing(ctx);
  }
  ImGui::EndPopup();
}

}  // namespace alphascope
