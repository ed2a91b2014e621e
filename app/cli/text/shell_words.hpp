// A command line as text that a shell accepts.
#pragma once

#include <string>
#include <vector>

namespace alphascope::cli {

// The program's name and its arguments as one line, quoted where needed, such as "alphascope-cli
// screenshot 'my molecule.pdb' --alpha 1.4". The output's name is left out, so that equal pictures
// hold equal text. Unprintable characters are escaped. `threads`: false leaves out the number of
// threads.
std::string command_text(const std::vector<std::string>& arguments, bool threads = true);

}  // namespace alphascope::cli
