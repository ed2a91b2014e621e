// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that hide atoms in the picture or give them colours. They compute no new complex.
#include <optional>
#include <utility>

#include "app/viewer/commands/command_parts.hpp"
#include "core/chart/colour_text.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_error.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {

NamedOrSelectedAtoms named_or_selected_atoms(const ViewState& s, const std::string& text) {
  const Molecule& molecule = s.references->molecule();
  const std::vector<bool> selected = atoms_of(molecule, s.settings.selection.items);
  if (text.empty()) {
    AtomSet atoms = atom_set(molecule, selected);
    const bool none = atoms.empty();
    return {std::move(atoms), none ? "Nothing of this molecule is selected. Select atoms, or name "
                                     "them."
                                   : ""};
  }
  try {
    const std::vector<bool> hidden = atoms_of(molecule, s.settings.appearance.hidden);
    AtomSet set = named_set(molecule, text, {&selected, &hidden});
    const bool none = set.empty();
    return {std::move(set), none ? "The molecule has no atom of this name." : ""};
  } catch (const SelectionError& error) {
    return {{}, std::string("Cannot understand the atoms: ") + error.what() + "."};
  }
}

Parameter which_atoms() {
  return {.name = "atoms",
          .help = "As in Select atoms; if left out, the selection",
          .example = "byres within 5 of resn HEM",
          .optional = true};
}

std::function<std::string()> without_picture(const ViewState& s) {
  return [&s] {
    return s.references ? "" : s.molecule.loaded ? kNoComplexYet : "No molecule is open.";
  };
}

namespace {

// Makes a command on the atoms that its parameter names or, without a name, on the selection.
CommandSpec on_atoms(ViewState& s, CommandSpec spec, std::function<void(const AtomSet&)> act) {
  spec.parameters.push_back(which_atoms());
  spec.why_not = without_picture(s);
  spec.run = [&s, act = std::move(act)](const Arguments& arguments) {
    const NamedOrSelectedAtoms found = named_or_selected_atoms(s, arguments.text("atoms"));
    if (!found.fault.empty()) return Outcome::refused(found.fault);
    act(found.atoms);
    return Outcome();
  };
  return spec;
}

CommandSpec colour_command(ViewState& s) {
  CommandSpec spec{.id = "atoms.colour",
                   .title = "Colour atoms…",
                   .help = "Gives atoms a colour of their own",
                   .menu = "Edit",
                   .parameters = {{.name = "colour",
                                   .help = "Red, green and blue in hexadecimal digits",
                                   .example = "#ff8800"},
                                  which_atoms()}};
  spec.why_not = without_picture(s);
  spec.run = [&s](const Arguments& arguments) {
    const std::string text = arguments.text("colour");
    const std::optional<Rgb8> colour = read_colour(text);
    if (!colour) {
      return Outcome::refused("\"" + text +
                              "\" is not a colour. Write one such as #ff8800 or #f80.");
    }
    const NamedOrSelectedAtoms found = named_or_selected_atoms(s, arguments.text("atoms"));
    if (!found.fault.empty()) return Outcome::refused(found.fault);
    set_colour(s.settings.appearance, found.atoms, colour);
    return Outcome();
  };
  return spec;
}

}  // namespace

void add_appearance_commands(Commands& commands, ViewState& s) {
  commands.add(on_atoms(s,
                        {.id = "atoms.hide",
                         .title = "Hide atoms",
                         .help = "Hides atoms, and simplices with a corner among them",
                         .shortcuts = {{"H"}},
                         .menu = "Edit",
                         .line_above = true},
                        [&s](const AtomSet& atoms) {
                          s.settings.appearance.hidden = s.settings.appearance.hidden.with(atoms);
                        }));
  commands.add(on_atoms(s,
                        {.id = "atoms.show",
                         .title = "Show atoms",
                         .help = "Shows hidden atoms again",
                         .menu = "Edit"},
                        [&s](const AtomSet& atoms) {
                          s.settings.appearance.hidden =
                              s.settings.appearance.hidden.without(atoms);
                        }));
  commands.add(on_atoms(s,
                        {.id = "atoms.only",
                         .title = "Show only these atoms",
                         .help = "Shows these atoms and hides all others",
                         .shortcuts = {{"I"}},
                         .menu = "Edit"},
                        [&s](const AtomSet& atoms) {
                          s.settings.appearance.hidden =
                              all_atoms(s.references->molecule()).without(atoms);
                        }));
  commands.add(
      {.id = "atoms.show_all",
       .title = "Show all atoms",
       .help = "Shows all hidden atoms again",
       .shortcuts = {{"Shift+H"}},
       .menu = "Edit",
       .why_not = [&s] { return s.settings.appearance.hidden.empty() ? "No atom is hidden." : ""; },
       .run =
           [&s](const Arguments&) {
             s.settings.appearance.hidden = {};
             return Outcome();
           }});
  commands.add(colour_command(s));
  commands.add(on_atoms(
      s,
      {.id = "atoms.usual_colour",
       .title = "Usual colour of atoms",
       .help = "Removes atoms' own colours",
       .menu = "Edit"},
      [&s](const AtomSet& atoms) { set_colour(s.settings.appearance, atoms, std::nullopt); }));
}

}  // namespace alphascope
