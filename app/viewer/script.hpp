// Drives the window by a script, through the same frames and widgets that a user has.
//
//   move NAME [FX FY]   mouse to a widget, scrolled into sight; FX, FY from 0 to 1 inside it
//                       (default its middle). A NAME that ends in * is the first that starts so
//   down | up           left mouse button
//   click NAME [FX FY]  move, down, up
//   double-click NAME   as click, twice
//   wheel STEPS         over what the mouse is on
//   type TEXT           into the focused field
//   key NAME            enter escape backspace f1 left right ctrl+o ctrl+a … or a letter
//   wait-idle           until nothing is computed any more
//   frames N            let N frames pass
//   open FILE           as dropping a file on the window
//   size W H            of the window, pixels
//   shot FILE           picture of the whole window as PNG
//   print               counts and hash of the result to standard output
//   time TEXT           milliseconds since the last `time` to standard output
//   memory TEXT         megabytes (10^6 bytes) resident, and of the heap in use, to standard output
//   when CONDITION      what follows, up to `end`, only if the molecule has any: dropped (atoms),
//                       guessed (radii, or set by hand), chains, models (more than one), assemblies
//   quit
//
// Empty lines and lines that start with # are skipped.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace alphascope {

class Viewer;

// Throws std::runtime_error that names file and line when a command is unknown or fails.
void run_script(Viewer& viewer, std::istream& script, const std::string& name, std::ostream& out);

}  // namespace alphascope
