// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the window by a script. It runs the commands of the menus (commands.hpp), and sends mouse
// and keys through the same frames and widgets. `alphascope --script-help` lists both.
#pragma once

#include <iosfwd>
#include <string>

namespace alphascope {

class Viewer;

// The help on all commands and their parameters, as text.
std::string script_help();

// Throws std::runtime_error with file and line for a command that is unknown or fails.
void run_script(Viewer& viewer, std::istream& script, const std::string& name, std::ostream& out);

}  // namespace alphascope
