// A command line as text that a shell takes back.
#pragma once

#include <string>
#include <vector>

namespace alphascope::cli {

// "alphascope-cli screenshot 'my molecule.pdb' --alpha 1.4": the program by its name, then its
// arguments, quoted where they must be, but for the name of the output: the same picture holds the
// same text wherever it is written. One line; what cannot be shown is escaped.
// `threads`: false leaves out how many there were.
std::string command_text(const std::vector<std::string>& arguments, bool threads = true);

}  // namespace alphascope::cli
