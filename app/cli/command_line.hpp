// SPDX-License-Identifier: GPL-3.0-or-later
// The command line's entry: parses the arguments and runs the command that they name.
#pragma once

namespace alphascope::cli {

// Returns the exit status of the process. Prints messages and throws nothing.
int run_command_line(int argc, const char* const* argv);

}  // namespace alphascope::cli
