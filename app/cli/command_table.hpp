// SPDX-License-Identifier: GPL-3.0-or-later
// Makes one table of the program's options and of its commands.
#pragma once

#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

struct CommandOptions {
  std::vector<Command> commands = all_commands();
  Verbosity verbosity = Verbosity::normal;
  bool times = true;  // false: --no-times
};

// Parsing the table sets `options`, which must outlive the table.
OptionProgram command_table(CommandOptions& options);

}  // namespace alphascope::cli
