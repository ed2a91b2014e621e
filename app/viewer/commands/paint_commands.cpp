// Commands that choose the paint of balls and simplices.
#include "app/viewer/commands/command_parts.hpp"
#include "core/document/settings/paint.hpp"

namespace alphascope {
namespace {

CommandSpec paint_command(CommandSpec spec, Painted what, Paint& paint) {
  spec.menu = "View";
  spec.parameters = {
      {.name = "paint",
       .help = scheme_ids(what) +
               ", or a colour such as #5aa9e6; a quantity also "
               "with a colour map (" +
               colour_map_ids() + ") and a range, with commas between",
       .example = what == Painted::balls ? "b_factor,cividis,0:60" : "alpha,viridis,0:3"}};
  spec.run = [what, &paint](const Arguments& arguments) {
    const PaintWords words = read_paint(arguments.text("paint"), what);
    if (!words.error.empty()) return Outcome::refused(words.error);
    paint = words.paint;
    return Outcome();
  };
  return spec;
}

}  // namespace

void add_paint_commands(Commands& commands, ViewState& s) {
  commands.add(paint_command({.id = "view.colour_balls",
                              .title = "Colour balls by…",
                              .help = "Chooses what the colours of balls mean",
                              .line_above = true},
                             Painted::balls, s.settings.display.ball_paint));
  commands.add(paint_command({.id = "view.colour_simplices",
                              .title = "Colour simplices by…",
                              .help = "Chooses what the colours of simplices mean"},
                             Painted::simplices, s.settings.display.complex_paint));
}

}  // namespace alphascope
