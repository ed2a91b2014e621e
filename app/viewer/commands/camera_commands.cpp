// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that change the view, all but "Reset view".
#include <algorithm>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/settings/named_view.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

struct Side {
  const char *id, *title;
  std::array<double, 3> towards_viewer;
};
constexpr Side kSides[] = {{"x", "From +x", {1, 0, 0}}, {"-x", "From −x", {-1, 0, 0}},
                           {"y", "From +y", {0, 1, 0}}, {"-y", "From −y", {0, -1, 0}},
                           {"z", "From +z", {0, 0, 1}}, {"-z", "From −z", {0, 0, -1}}};

Outcome look_along(const Arguments& arguments, const Calls& ask) {
  for (const Side& side : kSides) {
    if (arguments.text("side") == side.id) ask.view.look_from(side.towards_viewer);
  }
  return {};
}

std::vector<Choice> saved_views(const ViewState& s) {
  std::vector<Choice> choices;
  for (const NamedView& view : s.settings.views) choices.push_back({view.name, view.name});
  return choices;
}

std::function<std::string()> without_saved_views(const ViewState& s) {
  return [&s] { return s.settings.views.empty() ? "No camera is saved." : ""; };
}

Parameter saved_view(const ViewState& s) {
  return {.name = "name", .kind = Kind::choice, .help = "Which camera", .choices = [&s] {
            return saved_views(s);
          }};
}

void add_saved_view_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add({.id = "view.save_camera",
                .title = "Save camera…",
                .help = "Saves the present camera under a name",
                .menu = "View",
                .line_above = true,
                .parameters = {{.name = "name",
                                .kind = Kind::text,
                                .help = "Its name; an older camera of that name is replaced",
                                .example = "active site"}},
                .why_not = without_molecule(s),
                .run = [ask](const Arguments& arguments) {
                  ask.view.save(arguments.text("name"));
                  return Outcome();
                }});
  commands.add({.id = "view.camera",
                .title = "Go to a saved camera…",
                .help = "Restores a saved camera",
                .menu = "View",
                .parameters = {saved_view(s)},
                .why_not = without_saved_views(s),
                .run = [ask](const Arguments& arguments) {
                  ask.view.go_to(arguments.text("name"));
                  return Outcome();
                }});
  commands.add({.id = "view.forget_camera",
                .title = "Forget a saved camera…",
                .help = "Removes a saved camera",
                .parameters = {saved_view(s)},
                .why_not = without_saved_views(s),
                .run = [&s](const Arguments& arguments) {
                  std::erase_if(s.settings.views, [&](const NamedView& view) {
                    return view.name == arguments.text("name");
                  });
                  return Outcome();
                }});
}

void add_history_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "view.back",
       .title = "Previous view",
       .help = "Goes back to the view before the last movement; settings stay",
       .synonyms = {{"camera undo"}},
       .shortcuts = {{"V"}},
       .menu = "View",
       .why_not = [&s] { return s.viewport.has_earlier_view ? "" : "There is no earlier view."; },
       .run =
           [ask](const Arguments&) {
             ask.view.back();
             return Outcome();
           }});
  commands.add(
      {.id = "view.forward",
       .title = "Next view",
       .help = "Goes to the view that “Previous view” left",
       .synonyms = {{"camera redo"}},
       .shortcuts = {{"Shift+V"}},
       .menu = "View",
       .why_not = [&s] { return s.viewport.has_later_view ? "" : "There is no later view."; },
       .run =
           [ask](const Arguments&) {
             ask.view.forward();
             return Outcome();
           }});
  commands.add(with_switch({.id = "view.glide",
                            .title = "Gliding views",
                            .help = "Commands move the view in about 0.3 s instead of at once",
                            .menu = "View"},
                           s.window.glide));
}

}  // namespace

void add_camera_commands(Commands& commands, ViewState& s, const Calls& ask) {
  Parameter from{.name = "side", .kind = Kind::choice, .help = "The side of the camera"};
  from.choices = [] {
    std::vector<Choice> choices;
    for (const Side& side : kSides) choices.push_back({side.id, side.title});
    return choices;
  };
  commands.add(
      {.id = "view.from",
       .title = "Look along an axis",
       .help = "Looks at the same point from one of six sides",
       .synonyms = {{"rotate turn orient side"}},
       .shortcuts = {{"1", "x"}, {"2", "-x"}, {"3", "y"}, {"4", "-y"}, {"5", "z"}, {"6", "-z"}},
       .menu = "View",
       .line_above = true,
       .parameters = {from},
       .why_not = without_molecule(s),
       .run = [ask](const Arguments& arguments) { return look_along(arguments, ask); }});
  static constexpr NumberRule kZoomRule{"The factor", 0.01, 100};
  commands.add({.id = "view.zoom",
                .title = "Zoom…",
                .help = "Zooms in or out around the middle of the view",
                .parameters = {{.name = "factor",
                                .kind = Kind::number,
                                .help = "Factor of the size; above 1 zooms in",
                                .example = "0.7",
                                .rule = kZoomRule}},
                .why_not = without_molecule(s),
                .run = [ask](const Arguments& arguments) {
                  ask.view.zoom(arguments.number("factor"));
                  return Outcome();
                }});
  commands.add(display_command(s, display_field(&DisplaySettings::orthographic)));
  add_history_commands(commands, s, ask);
  add_saved_view_commands(commands, s, ask);
}

}  // namespace alphascope
