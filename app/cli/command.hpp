// A command of the command line. One source makes it, and command_list.cpp lists it.
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
  // `arguments`: as given, the program's name first. Throws what went wrong (failure.hpp).
  std::function<ExitCode(const std::vector<std::string>& arguments)> run;
  bool times_are_the_result = false;  // then it has no --no-times
};

// `describe` makes the table, which sets an Options; `run` gets this. Examples are whole lines.
template <class Options>
Command make_command(OptionCommand (*describe)(Options&), ExitCode (*run)(const Options&),
                     std::vector<std::string> examples) {
  const auto options = std::make_shared<Options>();
  Command command{describe(*options),
                  [options, run](const std::vector<std::string>&) { return run(*options); }};
  command.table.examples = std::move(examples);
  return command;
}

// In the order of the help.
std::vector<Command> all_commands();

}  // namespace alphascope::cli
