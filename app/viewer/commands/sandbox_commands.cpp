// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that create and edit balls of the sandbox.
#include "app/viewer/commands/command_parts.hpp"

#include <stdexcept>
#include "app/viewer/resources.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/sandbox.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

constexpr NumberRule kBallRule{"A ball", 1, kMostSandboxBalls, "", true};
constexpr NumberRule kCoordinateRule{"A coordinate", -kSandboxReach, kSandboxReach, "Å"};
constexpr NumberRule kRadiusRule{"A radius", 1e-6, kMostSandboxRadius, "Å"};

Parameter number(const char* name, const char* help, const char* example, const NumberRule& rule) {
  return {.name = name, .kind = Kind::number, .help = help, .example = example, .rule = rule};
}

Parameter optional(Parameter parameter) {
  parameter.optional = true;
  return parameter;
}

SandboxPlace place_of(const Arguments& arguments) {
  return {arguments.number("x"), arguments.number("y"), arguments.number("z")};
}

// Returns the index of the ball, even if there is no such ball.
std::size_t ball_of(const Arguments& arguments) {
  return static_cast<std::size_t>(arguments.number("ball")) - 1;
}

Outcome open_preset(const Arguments& arguments, ViewState& s, const Calls& ask) {
  const std::string id = arguments.text("preset");
  for (const SandboxPreset& preset : sandbox_presets()) {
    if (preset.id != id) continue;
    ask.files.open(preset.path);
    s.sandbox.edit_when_open = preset.path;
    s.window.page = "sandbox";
    return {};
  }
  return Outcome::refused("The file of this preset is missing.");
}

Outcome by_hand(const Arguments& arguments, ViewState& s) {
  bool on = s.settings.open.sandbox.has_value();
  if (Outcome outcome = set_switch(arguments, on); !outcome.done()) return outcome;
  if (on) {
    start_sandbox(s);
    s.window.page = "sandbox";
  } else if (s.settings.open.sandbox) {
    s.settings.open.sandbox.reset();
    s.settings.selection.clear();
  }
  return {};
}

Outcome set_flat(const Arguments& arguments, ViewState& s) {
  bool flat = s.settings.open.sandbox->flat;
  if (Outcome outcome = set_switch(arguments, flat); !outcome.done()) return outcome;
  if (flat) {
    flatten(*s.settings.open.sandbox);
  } else {
    s.settings.open.sandbox->flat = false;
  }
  return {};
}

// A command that changes the balls of the sandbox.
CommandSpec changing(CommandSpec spec, ViewState& s,
                     std::function<void(const Arguments&, Sandbox&)> change) {
  spec.why_not = [&s] {
    return s.settings.open.sandbox ? ""
                                   : "These balls cannot be edited. Open a preset on the page "
                                     "Sandbox, or switch “Balls by hand” on.";
  };
  spec.run = [&s, change = std::move(change)](const Arguments& arguments) {
    try {
      change(arguments, *s.settings.open.sandbox);
    } catch (const std::invalid_argument& error) {
      return Outcome::refused(std::string("The ball cannot be changed: ") + error.what() + ".");
    }
    return Outcome();
  };
  return spec;
}

void add_changes(Commands& commands, ViewState& s) {
  const std::vector<Parameter> place{
      number("x", "x of the ball's centre, Å", "1.5", kCoordinateRule),
      number("y", "y of the ball's centre, Å", "0", kCoordinateRule),
      number("z", "z of the ball's centre, Å", "0", kCoordinateRule)};
  const Parameter ball = number("ball", "Its number, from 1", "1", kBallRule);
  const Parameter radius = number("radius", "Its radius", "1.5", kRadiusRule);
  std::vector<Parameter> added = place, moved = place;
  added.push_back(optional(radius));
  moved.insert(moved.begin(), ball);
  commands.add(changing({.id = "sandbox.add",
                         .title = "Add a ball",
                         .help = "Adds a ball to the sandbox and selects it",
                         .parameters = added},
                        s, [&s](const Arguments& a, Sandbox& sandbox) {
                          const double r = a.number("radius", s.sandbox.next_radius_angstrom);
                          select_ball(s, add_ball(sandbox, place_of(a), r));
                        }));
  commands.add(changing({.id = "sandbox.move",
                         .title = "Move a ball",
                         .help = "Moves a ball of the sandbox",
                         .parameters = moved},
                        s, [](const Arguments& a, Sandbox& sandbox) {
                          move_ball(sandbox, ball_of(a), place_of(a));
                        }));
  commands.add(changing({.id = "sandbox.resize",
                         .title = "Resize a ball",
                         .help = "Gives a ball of the sandbox another radius",
                         .parameters = {ball, radius}},
                        s, [](const Arguments& a, Sandbox& sandbox) {
                          resize_ball(sandbox, ball_of(a), a.number("radius"));
                        }));
  CommandSpec remove =
      changing({.id = "sandbox.remove",
                .title = "Remove balls",
                .help = "Removes a ball of the sandbox, or those that are selected",
                .shortcuts = {{"Delete"}},
                .parameters = {optional(ball)}},
               s, [&s](const Arguments& a, Sandbox& sandbox) {
                 if (!a.has("ball")) return remove_selected_balls(s);
                 remove_ball(sandbox, ball_of(a));
                 s.settings.selection.clear();
               });
  commands.add(std::move(remove));
}

}  // namespace

void add_sandbox_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "sandbox.new",
       .title = "Sandbox…",
       .help = "Opens a few balls that can be moved, resized, added and removed",
       .menu = "Tools",
       .line_above = true,
       .parameters = {{.name = "preset",
                       .kind = Kind::choice,
                       .help = "Which balls",
                       .example = "square",
                       .choices =
                           [] {
                             std::vector<Choice> choices;
                             for (const SandboxPreset& p : sandbox_presets()) {
                               choices.push_back({p.id, p.title, p.detail});
                             }
                             return choices;
                           }}},
       .run = [&s, ask](const Arguments& arguments) { return open_preset(arguments, s, ask); }});
  commands.add({.id = "sandbox.by_hand",
                .title = "Balls by hand",
                .help = "Lets you change the balls on screen; off: the balls of the file again",
                .menu = "Tools",
                .parameters = {on_or_off()},
                .why_not = [&s] { return why_not_editable(s); },
                .checked = [&s] { return s.settings.open.sandbox.has_value(); },
                .run = [&s](const Arguments& arguments) { return by_hand(arguments, s); }});
  commands.add(
      {.id = "sandbox.flat",
       .title = "Balls in a plane",
       .help = "Moves every ball of the sandbox to z = 0 and keeps it there",
       .parameters = {on_or_off()},
       .why_not =
           [&s] {
             return s.settings.open.sandbox ? ""
                                            : "These balls cannot be edited. Open a preset on the "
                                              "page Sandbox, or switch “Balls by hand” on.";
           },
       .checked = [&s] { return s.settings.open.sandbox && s.settings.open.sandbox->flat; },
       .run = [&s](const Arguments& arguments) { return set_flat(arguments, s); }});
  SandboxState& m = s.sandbox;
  commands.add(with_switch({.id = "sandbox.drawing",
                            .title = "Flat drawing",
                            .help = "Draws balls in a plane flat, in the place of the picture"},
                           m.drawing));
  commands.add(with_switch({.id = "sandbox.discs",
                            .title = "Grown discs",
                            .help = "Shows in the flat drawing how alpha grows the balls"},
                           m.content.discs));
  commands.add(with_switch({.id = "sandbox.cells",
                            .title = "Power diagram in the flat drawing",
                            .help = "Shows the power diagram in the flat drawing"},
                           m.content.cells));
  commands.add(with_switch({.id = "sandbox.complex",
                            .title = "Complex in the flat drawing",
                            .help = "Shows the dual complex in the flat drawing"},
                           m.content.complex));
  add_changes(commands, s);
}

}  // namespace alphascope
