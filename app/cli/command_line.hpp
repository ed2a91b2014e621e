// Parsing the command line and running the command it names.
#pragma once

namespace alphascope::cli {

// Returns the process' exit status. Prints messages; throws nothing.
int run_command_line(int argc, const char* const* argv);

}  // namespace alphascope::cli
