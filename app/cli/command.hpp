// SPDX-License-Identifier: GPL-3.0-or-later
// A command of the command line. Each command has its own source, and command_list.cpp lists it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/options/exit_code.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

struct Command {
  OptionCommand table;  // name, help, examples, options and their check
  // `arguments` begin with the program's name. Throws exceptions that failure.hpp turns into
  // messages.
  std::function<ExitCode(const std::vector<std::string>& arguments)> run;
  bool times_are_the_result = false;  // if true, the command has no --no-times
};

// Makes a command. `describe` makes the table whose options set an `Options`, and `run` gets that
// `Options`. Examples are whole lines.
template <class Options>
Command make_command(OptionCommand (*describe)(Options&), ExitCode (*run)(const Options&),
                     std::vector<std::string> examples) {
  const auto options = std::make_shared<Options>();
  Command command{describe(*options),
                  [options, run](const std::vector<std::string>&) { return run(*options); }};
  command.table.examples = std::move(examples);
  return command;
}

// All commands, in the order of the help.
std::vector<Command> all_commands();
// The command that the first word after the program's name is. All commands where it is none, as
// help and messages list them. None for the version alone. The tables of all commands take as long
// as the rest of the start.
std::vector<Command> needed_commands(const std::vector<std::string>& words);

}  // namespace alphascope::cli
