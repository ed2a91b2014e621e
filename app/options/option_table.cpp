// SPDX-License-Identifier: GPL-3.0-or-later
// Derives names and choices of options, and adds the standard options.
#include "app/options/option_table.hpp"

#include <algorithm>
#include <cctype>

#include "core/text/text_parts.hpp"

namespace alphascope {
namespace {

bool is_placeholder(const std::string& word) {
  return std::isupper(static_cast<unsigned char>(word.front())) != 0;
}

// The command `help`, which many programs have besides --help. `help COMMAND` works, too.
OptionCommand help_command(const OptionProgram& program) {
  std::string known;
  for (const OptionCommand& c : program.commands) known += c.name + "|";
  known += "help";
  return {.name = "help",
          .text = "Print the help of the program, or that of a command",
          .options = {{.names = "COMMAND",
                       .value = known,
                       .text = "The command to explain",
                       .answer = InsteadOfRunning::help}},
          .answer = InsteadOfRunning::help};
}

}  // namespace

std::vector<std::string> Option::all_names() const {
  return parts_of(names, ',');
}

std::string Option::shown_name() const {
  return all_names().back();
}

std::vector<std::string> Option::choices() const {
  std::vector<std::string> words = parts_of(value, '|');
  std::erase_if(words, is_placeholder);
  return words;
}

bool Option::takes_file() const {
  for (const std::string& word : parts_of(value, '|')) {
    for (const char* kind : {"FILE", "OUT", "LIST", "DIR"}) {
      if (word.starts_with(kind)) return true;
    }
  }
  return false;
}

std::string Option::shown_value() const {
  return value + (list && !is_argument() ? ",..." : "");
}

const OptionCommand* OptionProgram::find(const std::string& command) const {
  const auto named = [&](const OptionCommand& c) { return c.name == command; };
  const auto found = std::find_if(commands.begin(), commands.end(), named);
  return found == commands.end() ? nullptr : &*found;
}

std::vector<std::string> OptionProgram::command_names() const {
  std::vector<std::string> names;
  for (const OptionCommand& command : commands) names.push_back(command.name);
  return names;
}

void add_standard_options(OptionProgram& program) {
  const Option help{
      .names = "-h,--help", .text = "Print this help", .answer = InsteadOfRunning::help};
  const Option version{.names = "-V,--version",
                       .text = "Print name, version and commit",
                       .answer = InsteadOfRunning::version};
  if (!program.commands.empty()) program.commands.push_back(help_command(program));
  for (OptionCommand& command : program.commands) {
    command.options.push_back(help);
    command.options.push_back(version);
  }
  program.options.push_back(help);
  program.options.push_back(version);
  program.options.push_back({.names = "--man-page",
                             .text = "Print the manual page",
                             .answer = InsteadOfRunning::man_page});
  program.options.push_back({.names = "--completion",
                             .value = "bash|zsh|fish",
                             .text = "Print a script that completes commands and options",
                             .answer = InsteadOfRunning::completion});
}

std::vector<std::string> dashed_names(const std::vector<Option>& options) {
  std::vector<std::string> names;
  for (const Option& option : options) {
    if (option.is_argument()) continue;
    for (const std::string& name : option.all_names()) names.push_back(name);
  }
  return names;
}

}  // namespace alphascope
