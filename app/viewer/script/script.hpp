// Drives the window by a script: by the commands of its menus (commands.hpp), and by mouse and keys
// through the same frames and widgets that a user has. `alphascope --script-help` lists both.
#pragma once

#include <iosfwd>
#include <string>

namespace alphascope {

class Viewer;

// Every command and what it takes, for people.
std::string script_help();

// Throws std::runtime_error that names file and line when a command is unknown or fails.
void run_script(Viewer& viewer, std::istream& script, const std::string& name, std::ostream& out);

}  // namespace alphascope
