// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the objects that are drawn of atoms.
#include <algorithm>
#include <string>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/settings/drawn_object.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

bool any_shown(const DrawnObjects& objects, ObjectKind kind) {
  return std::any_of(objects.begin(), objects.end(),
                     [kind](const DrawnObject& o) { return o.kind == kind && o.shown; });
}

// Shows or hides all objects of a kind. Without one, `fresh` is added.
Outcome switch_kind(const Arguments& arguments, DrawnObjects& objects, const DrawnObject& fresh) {
  bool wanted = any_shown(objects, fresh.kind);
  const Outcome outcome = set_switch(arguments, wanted);
  if (!outcome.done()) return outcome;
  bool any = false;
  for (DrawnObject& object : objects) {
    if (object.kind != fresh.kind) continue;
    object.shown = wanted;
    any = true;
  }
  if (wanted && !any) {
    if (objects.size() >= kMostObjects) {
      return Outcome::refused("There are " + std::to_string(kMostObjects) +
                              " objects already. Remove one first.");
    }
    objects.push_back(fresh);
  }
  return {};
}

CommandSpec kind_command(ViewState& s, const char* id, const char* title, const char* help,
                         DrawnObject fresh) {
  const ObjectKind kind = fresh.kind;
  return {.id = id,
          .title = title,
          .help = help,
          .menu = "View",
          .parameters = {on_or_off()},
          .why_not = without_molecule(s),
          .checked = [&s, kind] { return any_shown(s.settings.objects, kind); },
          .run =
              [&s, fresh](const Arguments& arguments) {
                return switch_kind(arguments, s.settings.objects, fresh);
              }};
}

}  // namespace

void add_object_commands(Commands& commands, ViewState& s) {
  CommandSpec cartoon = kind_command(s, "view.cartoon", "Cartoon",
                                     "Draws ribbons of proteins, ladders of nucleic acids",
                                     {.kind = ObjectKind::cartoon});
  cartoon.synonyms = {{"ribbon helix strand secondary structure"}};
  cartoon.shortcuts = {{"Shift+C"}};
  cartoon.line_above = true;
  commands.add(std::move(cartoon));
  CommandSpec sticks = kind_command(
      s, "view.sticks", "Ligands as sticks", "Draws the bonds of ligands",
      {.kind = ObjectKind::sticks, .atoms = "ligand", .colour = ObjectColour::element});
  sticks.synonyms = {{"bonds licorice"}};
  commands.add(std::move(sticks));
  commands.add(
      {.id = "view.objects",
       .title = "Objects",
       .help = "Replaces the list of objects: " + object_kind_ids() +
               ", each with a colour, an opacity and atoms, or without",
       .synonyms = {{"representation sticks points ball-and-stick"}},
       .parameters = {{.name = "objects",
                       .kind = Kind::text,
                       .help = "The list, with semicolons between objects; none removes all",
                       .example = "cartoon,secondary,40%:chain A; sticks:ligand"}},
       .why_not = without_molecule(s),
       .run = [&s](const Arguments& arguments) {
         ObjectListWords words = read_objects(arguments.text("objects"));
         if (!words.error.empty()) return Outcome::refused(words.error);
         s.settings.objects = std::move(words.objects);
         return Outcome();
       }});
}

}  // namespace alphascope
