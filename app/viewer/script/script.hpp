// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the window by a script. It runs the commands of the menus (commands.hpp), and sends mouse
// and keys through the same frames and widgets. `alphascope --script-help` lists both.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>

#include "ui/panels/error_kind.hpp"

namespace alphascope {

class Viewer;

// The help on all commands and their parameters, as text.
std::string script_help();

// A command is unknown or fails. what() names file and line.
struct ScriptError : std::runtime_error {
  ScriptError(const std::string& text, ErrorKind of_kind)
      : std::runtime_error(text), kind(of_kind) {}
  ErrorKind kind;
};

// Throws ScriptError.
void run_script(Viewer& viewer, std::istream& script, const std::string& name, std::ostream& out);

}  // namespace alphascope
