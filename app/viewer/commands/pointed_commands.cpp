// SPDX-License-Identifier: GPL-3.0-or-later
// Commands on the item under the mouse, and the context menu.
#include <algorithm>
#include <utility>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/reference/atom_measurements.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {

const std::optional<Ref>& pointed(const ViewState& s) {
  return s.context.open ? s.context.what : s.hovered;
}

namespace {

CommandSpec on_pointed(ViewState& s, CommandSpec spec, std::function<Outcome(const Ref&)> act) {
  if (!spec.why_not) {
    spec.why_not = [&s] {
      return s.references && pointed(s) ? "" : "No atom or simplex is under the mouse.";
    };
  }
  spec.run = [&s, act = std::move(act)](const Arguments&) { return act(*pointed(s)); };
  return spec;
}

void select(ViewState& s, RefSet items) {
  s.settings.selection.items = std::move(items);
  s.settings.selection.note_order();
}

// The distance or angle from one to three selected atoms to the atom under the mouse.
SelectedMeasurement measurement_to_pointed(const ViewState& s) {
  const AtomRef* const end = pointed(s) ? std::get_if<AtomRef>(&*pointed(s)) : nullptr;
  if (end == nullptr) return {{}, "Distances and angles need atoms. Point at an atom."};
  std::vector<AtomRef> atoms = s.settings.selection.atoms_in_order();
  std::erase(atoms, *end);
  if (atoms.empty() || atoms.size() > 3) {
    return {{},
            "Select an atom first, to measure the distance to this one. Two selected atoms "
            "give the angle, three the dihedral angle."};
  }
  atoms.push_back(*end);
  return {Measurement{std::move(atoms)}, {}};
}

void add_selecting(Commands& commands, ViewState& s) {
  commands.add(on_pointed(s,
                          {.id = "pointed.select",
                           .title = "Select the item under the mouse",
                           .help = "Selects the atom or simplex under the mouse, and nothing else"},
                          [&s](const Ref& ref) {
                            select(s, RefSet({ref}));
                            return Outcome();
                          }));
  commands.add(on_pointed(
      s,
      {.id = "pointed.toggle",
       .title = "Add what is under the mouse to the selection",
       .help = "Adds the atom or simplex under the mouse to the selection, or takes it out again"},
      [&s](const Ref& ref) {
        RefSet items = s.settings.selection.items.toggled(ref);
        if (items.size() > Selection::kMostItems) {
          return Outcome::refused("The selection is full. Clear it first.");
        }
        select(s, std::move(items));
        return Outcome();
      }));
  commands.add(on_pointed(s,
                          {.id = "pointed.why",
                           .title = "Why is this under the mouse here?",
                           .help = "Selects the atom or simplex under the mouse, and explains why "
                                   "it is in the complex or not"},
                          [&s](const Ref& ref) {
                            select(s, RefSet({ref}));
                            s.window.page = "why";
                            return Outcome();
                          }));
}

// A command that hands the atoms of its parameter, or the selection, to `call`.
CommandSpec viewpoint_for_balls(ViewState& s, const Calls& ask, CommandSpec spec,
                                void (ViewCalls::*call)(const RefSet&)) {
  spec.menu = "View";
  spec.parameters = {which_atoms()};
  spec.why_not = without_picture(s);
  spec.run = [&s, ask, call](const Arguments& arguments) {
    const std::string text = arguments.text("atoms");
    if (text.empty() && !s.settings.selection.items.empty()) {
      (ask.view.*call)(s.settings.selection.items);
      return Outcome();
    }
    const NamedOrSelectedAtoms asked = named_or_selected_atoms(s, text);
    if (!asked.fault.empty()) return Outcome::refused(asked.fault);
    std::vector<Ref> atoms;
    for (const AtomSet::Run& run : asked.atoms.runs()) {
      for (std::uint64_t atom = run.first; atom <= run.last; ++atom) {
        if (atoms.size() == Selection::kMostItems) break;
        atoms.emplace_back(AtomRef{static_cast<std::uint32_t>(atom), run.copy});
      }
    }
    (ask.view.*call)(RefSet(std::move(atoms)));
    return Outcome();
  };
  return spec;
}

}  // namespace

void add_pointed_commands(Commands& commands, ViewState& s, const Calls& ask) {
  add_selecting(commands, s);
  commands.add(
      viewpoint_for_balls(s, ask,
                          {.id = "view.zoom_to",
                           .title = "Zoom to atoms",
                           .help = "Moves atoms to the middle of the view, as large as they fit"},
                          &ViewCalls::zoom_to));
  commands.add(
      viewpoint_for_balls(s, ask,
                          {.id = "view.centre",
                           .title = "Centre rotation",
                           .help = "Moves atoms to the middle of the view, at the same size; "
                                   "the view then turns about them",
                           .shortcuts = {{"Shift+Z"}}},
                          &ViewCalls::centre_on));
  CommandSpec measure{.id = "pointed.measure",
                      .title = "Measure to what is under the mouse",
                      .help =
                          "Measures the distance from the selected atom to the one under the "
                          "mouse; with two selected the angle, with three the dihedral angle"};
  measure.why_not = [&s, without = without_picture(s)] {
    return s.references ? measurement_to_pointed(s).why_not : without();
  };
  commands.add(on_pointed(s, std::move(measure), [&s](const Ref&) {
    return add_measurement(s, *measurement_to_pointed(s).measurement);
  }));
  commands.add(on_pointed(s,
                          {.id = "pointed.copy_name",
                           .title = "Copy the name under the mouse",
                           .help = "Copies the name of the atom or simplex under the mouse"},
                          [&s, ask](const Ref& ref) {
                            const std::string name = name_of(s.references->molecule(), ref);
                            ask.files.copy(name);
                            s.notice = "Copied " + name;
                            return Outcome();
                          }));
  commands.add({.id = "view.context_menu",
                .title = "Menu of what is under the mouse",
                .help = "Opens the menu of the right mouse button where the mouse is in the view",
                .shortcuts = {{"Shift+F10"}, {"Menu"}},
                .why_not = without_molecule(s),
                .run = [ask](const Arguments&) {
                  ask.view.open_context_menu();
                  return Outcome();
                }});
}

}  // namespace alphascope
