// SPDX-License-Identifier: GPL-3.0-or-later
// Parses arguments and sets variables. Only the source of this header uses the parser CLI11.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

struct ParsedArguments {
  // The command that was named. Null for a program without commands.
  const OptionCommand* command = nullptr;
  bool ended = false;  // the program has to print `text` and exit
  int exit_code = 0;   // for `ended`; if not 0, `text` is an error
  std::string text;    // with a final line end
};

// Sets the variables of the options. An error names program, option and reason, and proposes
// similar names.
ParsedArguments parse_arguments(const OptionProgram& program, int argc, const char* const* argv);

}  // namespace alphascope
