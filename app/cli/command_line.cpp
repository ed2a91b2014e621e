// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the command that the arguments name, and turns exceptions into messages and exit codes.
#include "app/cli/command_line.hpp"

#include <algorithm>
#include <iostream>

#include "app/cli/command_table.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/options/parse_arguments.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_parts.hpp"

namespace alphascope::cli {
namespace {

const Command& named(const std::string& name, const CommandOptions& options) {
  return *std::find_if(options.commands.begin(), options.commands.end(),
                       [&](const Command& command) { return command.table.name == name; });
}

int parse_and_run(int argc, const char* const* argv) {
  CommandOptions options{needed_commands({argv + std::min(argc, 1), argv + argc})};
  const OptionProgram program = command_table(options);
  const ParsedArguments parsed = parse_arguments(program, argc, argv);
  if (parsed.ended) {
    if (parsed.exit_code == 0) {
      std::cout << parsed.text << std::flush;
    } else {  // an error of several lines, which may quote typed text
      for (const std::string& line : parts_of(parsed.text, '\n')) {
        std::cerr << printable(line) << '\n';
      }
    }
    return parsed.exit_code;
  }
  set_verbosity(options.verbosity);
  set_memory_remedy(*parsed.command);
  set_times_wanted(options.times);
  return static_cast<int>(named(parsed.command->name, options).run({argv, argv + argc}));
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (...) {
    const Failure failure = current_failure();
    print_error(failure.message);
    return failure.code == ExitCode::cancelled ? cancelled_status()
                                               : static_cast<int>(failure.code);
  }
}

}  // namespace alphascope::cli
