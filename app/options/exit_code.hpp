// What both programs end with: one table for scripts, the help, the manual pages and the guide.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

enum class ExitCode : int {
  ok = 0,
  differs = 1,            // verify and bench: not the same as CGAL
  usage = 2,              // invalid usage
  unreadable_input = 3,   // a file cannot be read or understood
  computing_failed = 4,   // engine unavailable, out of memory, internal error
  unwritable_output = 5,  // an output file cannot be written
  no_display = 6,         // the window's program: nothing to open a window on
  cancelled = 130,        // Ctrl-C, as shells expect (128 + SIGINT); other signals likewise
};

struct ExitCodeInfo {
  ExitCode code;
  const char* text;
};

const std::vector<ExitCodeInfo>& all_exit_codes();

// "3    a file cannot be read or understood", one a line.
std::vector<std::string> exit_code_lines();

}  // namespace alphascope
