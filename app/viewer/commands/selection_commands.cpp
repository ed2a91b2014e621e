// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that select by name or clear the selection, and that choose cavities.
#include <utility>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/settings/cavity_settings.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

constexpr const char* kNamesHelp =
    "CHAIN:RESIDUE:ATOM, or an expression such as byres within 5 of resn HEM";

std::string atoms_text(std::size_t count) {
  return with_separators(static_cast<long long>(count)) + (count == 1 ? " atom" : " atoms");
}

Outcome select(ViewState& s, const std::string& text, bool more) {
  NamedAtoms named;
  try {
    const std::vector<bool> selected =
        atoms_of(s.references->molecule(), s.settings.selection.items);
    const std::vector<bool> hidden =
        atoms_of(s.references->molecule(), s.settings.appearance.hidden);
    named = named_atoms(*s.references, text, {&selected, &hidden});
  } catch (const SelectionError& error) {
    return Outcome::refused(std::string("Cannot understand the atoms: ") + error.what() + ".");
  }
  if (named.balls.empty() && named.others == 0) {
    return Outcome::refused("The molecule has no atom of this name.");
  }
  if (named.balls.empty()) {
    return Outcome::refused(atoms_text(named.others) + (named.others == 1 ? " has" : " have") +
                            " this name, but the selection at the left leaves all of them out.");
  }
  RefSet items =
      more ? s.settings.selection.items.with(named.balls) : RefSet(std::move(named.balls));
  if (items.size() > Selection::kMostItems) {
    return Outcome::refused("This would select " +
                            with_separators(static_cast<long long>(items.size())) +
                            "; at most 100,000 can be selected at once. Name fewer atoms.");
  }
  static_assert(Selection::kMostItems == 100000);
  s.settings.selection.items = std::move(items);
  s.settings.selection.note_order();
  return {};
}

CommandSpec by_name(ViewState& s, bool more) {
  return {.id = more ? "select.add" : "select.atoms",
          .title = more ? "Add atoms to the selection…" : "Select atoms…",
          .help = more ? "Adds atoms to the selection by name"
                       : "Selects atoms by name, and nothing else",
          .menu = "Edit",
          .line_above = !more,
          .parameters = {{.name = "atoms", .help = kNamesHelp, .example = "A:HIS 87:NE2"}},
          .why_not = without_picture(s),
          .run = [&s, more](const Arguments& arguments) {
            return select(s, arguments.text("atoms"), more);
          }};
}

// The command only notes the row. The page chooses the cavity when its table is ready.
CommandSpec select_cavity(ViewState& s) {
  static constexpr NumberRule kRowRule{"The number", 1, 1e6, "", true};
  return {.id = "cavities.choose",
          .title = "Select a cavity…",
          .help = "Draws a cavity of the table and selects the atoms that line it",
          .menu = "Edit",
          .parameters = {{.name = "number",
                          .kind = Parameter::Kind::number,
                          .help = "Its number in the table; 1 has the largest SA volume",
                          .example = "1",
                          .rule = kRowRule}},
          .why_not = without_picture(s),
          .run = [&s](const Arguments& arguments) {
            s.window.page = "cavities";
            s.cavities.wanted_row = static_cast<std::size_t>(arguments.number("number")) - 1;
            return Outcome();
          }};
}

CommandSpec castp_choices(ViewState& s) {
  return {.id = "cavities.castp",
          .title = "Use CASTp's choices",
          .help = "Sets CASTp's radii, solvent radius, alpha and body, and does not split networks",
          .menu = "Edit",
          .why_not = without_picture(s),
          .run = [&s](const Arguments&) {
            use_cavity_preset(s.settings.open, s.settings.request, s.molecule.has_file_radii);
            s.settings.cavity_settings.split_networks = false;
            s.window.page = "cavities";
            return Outcome();
          }};
}

CommandSpec split_networks(ViewState& s) {
  CommandSpec command =
      with_switch({.id = "cavities.split_networks",
                   .title = "Split networks at their bottlenecks",
                   .help = "Lists cavities of twenty mouths or more as the parts that they fall "
                           "into while alpha grows"},
                  s.settings.cavity_settings.split_networks);
  command.menu = "Edit";
  command.why_not = without_picture(s);
  return command;
}

}  // namespace

void add_selection_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(by_name(s, false));
  commands.add(by_name(s, true));
  commands.add(select_cavity(s));
  commands.add(castp_choices(s));
  commands.add(split_networks(s));
  const auto nothing = [&s] { return s.settings.selection.empty() ? "Nothing is selected." : ""; };
  commands.add({.id = "select.none",
                .title = "Clear the selection",
                .help = "Removes everything from the selection",
                .menu = "Edit",
                .why_not = nothing,
                .run = [&s](const Arguments&) {
                  s.settings.selection.clear();
                  return Outcome();
                }});
  commands.add(
      {.id = "view.zoom_to_selection",
       .title = "Zoom to selection",
       .help = "Moves the selection to the middle of the view; the view then turns about it",
       .shortcuts = {{"Z"}},
       .menu = "View",
       .why_not =
           [&s] {
             if (s.settings.selection.items.empty()) return "Nothing is selected.";
             const bool none = s.selected_missing == s.settings.selection.items.size();
             return none ? "No selected item is in the picture." : "";
           },
       .run =
           [ask](const Arguments&) {
             ask.view.zoom_to_selection();
             return Outcome();
           }});
}

}  // namespace alphascope
