// SPDX-License-Identifier: GPL-3.0-or-later
// A command line as text that a shell accepts.
#pragma once

#include <string>
#include <vector>

namespace alphascope::cli {

// The program's name and its arguments as one line, quoted where needed, such as "alphascope-cli
// screenshot 'my molecule.pdb' --alpha 1.4". Leaves out the output's name, so equal pictures
// contain equal text. Escapes unprintable characters. If `threads` is false, leaves out the number
// of threads.
std::string command_text(const std::vector<std::string>& arguments, bool threads = true);

}  // namespace alphascope::cli
