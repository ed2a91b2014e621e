// The command that shows a page below the view, by its name or by what people call what it shows.
#include <string>

#include "app/viewer/command_parts.hpp"
#include "ui/panels/panel_list.hpp"

namespace alphascope {

// Without the buttons of the pages.
CommandSpec page_command(ViewState& s) {
  Parameter page{
      .name = "page", .kind = Parameter::Kind::choice, .help = "Which page", .example = "why"};
  page.choices = [&s] {
    std::vector<Choice> choices;
    for (const PanelSpec& panel : panels()) {
      if (panel.place != Place::bottom) continue;
      choices.push_back({panel.id, panel.title, "", s.memory.bottom_panel == panel.id});
    }
    return choices;
  };
  CommandSpec spec{.id = "view.page",
                   .title = "Page below the view",
                   .help = "Shows timings, cavities, the signature or another page",
                   .menu = "View",
                   .parameters = {page},
                   .run = [&s](const Arguments& arguments) {
                     s.memory.bottom_panel = arguments.text("page");
                     return Outcome();
                   }};
  for (const PanelSpec& panel : panels()) {
    if (panel.place != Place::bottom) continue;
    spec.synonyms.push_back({std::string(panel.title) + " " + panel.also, panel.id});
  }
  return spec;
}

}  // namespace alphascope
