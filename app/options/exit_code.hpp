// SPDX-License-Identifier: GPL-3.0-or-later
// The exit codes of both programs, one table for scripts, help, manual pages and guide.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

enum class ExitCode : int {
  ok = 0,
  differs = 1,            // verify and bench: the complex differs from CGAL's
  usage = 2,              // invalid usage
  unreadable_input = 3,   // a file cannot be read or understood
  computing_failed = 4,   // engine unavailable, out of memory, internal error
  unwritable_output = 5,  // an output file cannot be written
  no_display = 6,         // alphascope: no display to open a window on
  cancelled = 130,        // Ctrl-C, as shells expect (128 + SIGINT); 128 + n for signal n
};

struct ExitCodeInfo {
  ExitCode code;
  const char* text;
};

const std::vector<ExitCodeInfo>& all_exit_codes();

// Lines such as "3    a file cannot be read or understood".
std::vector<std::string> exit_code_lines();

}  // namespace alphascope
