// SPDX-License-Identifier: GPL-3.0-or-later
// The table of exit codes.
#include "app/options/exit_code.hpp"

namespace alphascope {

const std::vector<ExitCodeInfo>& all_exit_codes() {
  static const std::vector<ExitCodeInfo> codes{
      {ExitCode::ok, "done"},
      {ExitCode::differs, "differs from CGAL (verify, bench)"},
      {ExitCode::usage, "invalid usage"},
      {ExitCode::unreadable_input, "a file cannot be read or understood"},
      {ExitCode::computing_failed, "the result cannot be computed or drawn"},
      {ExitCode::unwritable_output, "an output cannot be written"},
      {ExitCode::no_display, "no display to open a window on (alphascope)"},
      {ExitCode::cancelled, "cancelled by Ctrl-C; by another signal 128 and its number"}};
  return codes;
}

std::vector<std::string> exit_code_lines() {
  std::vector<std::string> lines;
  for (const ExitCodeInfo& info : all_exit_codes()) {
    std::string line = std::to_string(static_cast<int>(info.code));
    line.resize(5, ' ');
    lines.push_back(line + info.text);
  }
  return lines;
}

}  // namespace alphascope
