// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the page that explains a simplex.
#include "app/viewer/commands/command_parts.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {

void add_why_commands(Commands& commands, ViewState& s) {
  commands.add({.id = "why.show",
                .title = "Why is this here?",
                .help = "Explains why the selected simplex, or that of two to four selected atoms, "
                        "is in the alpha complex or not",
                .shortcuts = {{"W"}},
                .menu = "Tools",
                .line_above = true,
                .why_not = without_molecule(s),
                .run = [&s](const Arguments&) {
                  s.window.page = "why";
                  return Outcome();
                }});
  commands.add(with_switch({.id = "why.marks",
                            .title = "Show the orthosphere",
                            .help = "Draws the orthosphere of the simplex that is explained, the "
                                    "nearest other ball, and the dual edge or facet"},
                           s.window.why_marks));
}

}  // namespace alphascope
