// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that show a page below the view or a section at its left. With synonyms, the palette
// finds a panel by its content too.
#include <functional>
#include <string>
#include <utility>

#include "app/viewer/commands/command_parts.hpp"
#include "ui/panels/frame/scroll_state.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

// Fills in the choices of `parameter`: the panels at `place`.
CommandSpec for_panels(CommandSpec spec, Parameter parameter, PanelPlace place,
                       const std::function<bool(const PanelSpec&)>& is_shown) {
  parameter.kind = Parameter::Kind::choice;
  parameter.choices = [place, is_shown] {
    std::vector<Choice> choices;
    for (const PanelSpec& panel : panels()) {
      if (panel.place != place) continue;
      choices.push_back({panel.id, panel.title, "", is_shown(panel)});
    }
    return choices;
  };
  spec.menu = "View";
  spec.parameters = {std::move(parameter)};
  for (const PanelSpec& panel : panels()) {
    if (panel.place != place) continue;
    spec.synonyms.push_back({std::string(panel.title) + " " + panel.also, panel.id});
  }
  return spec;
}

}  // namespace

CommandSpec page_command(ViewState& s) {
  return for_panels({.id = "view.page",
                     .title = "Page below the view",
                     .help = "Shows timings, cavities, the signature or another page",
                     .run =
                         [&s](const Arguments& arguments) {
                           s.window.page = s.window.chosen_page = arguments.text("page");
                           return Outcome();
                         }},
                    {.name = "page", .help = "Which page", .example = "why"}, PanelPlace::bottom,
                    [&s](const PanelSpec& p) { return s.page() == p.id; });
}

CommandSpec section_command(ViewState& s) {
  return for_panels({.id = "view.section",
                     .title = "Section at the left",
                     .help = "Opens radii, chains, colours, light or other settings",
                     .run =
                         [&s](const Arguments& arguments) {
                           s.scroll.section = arguments.text("section");
                           return Outcome();
                         }},
                    {.name = "section", .help = "Which section", .example = "molecule"},
                    PanelPlace::left,
                    [&s](const PanelSpec& p) { return !s.window.closed_sections.contains(p.id); });
}

}  // namespace alphascope
