// SPDX-License-Identifier: GPL-3.0-or-later
// The list of commands. A new command is a source that defines its function, and a line here.
#include "app/cli/command.hpp"

// The order is that of the help.
#define ALPHASCOPE_COMMANDS(COMMAND) \
  COMMAND(info)                      \
  COMMAND(compute)                   \
  COMMAND(cavities)                  \
  COMMAND(channel)                   \
  COMMAND(measure)                   \
  COMMAND(export)                    \
  COMMAND(explain)                   \
  COMMAND(steps)                     \
  COMMAND(fetch)                     \
  COMMAND(formats)                   \
  COMMAND(verify)                    \
  COMMAND(bench)                     \
  COMMAND(screenshot)                \
  COMMAND(frames)                    \
  COMMAND(columns)

namespace alphascope::cli {

#define ALPHASCOPE_DECLARED(name) Command name##_command();
ALPHASCOPE_COMMANDS(ALPHASCOPE_DECLARED)

std::vector<Command> all_commands() {
  std::vector<Command> commands;
#define ALPHASCOPE_LISTED(name) commands.push_back(name##_command());
  ALPHASCOPE_COMMANDS(ALPHASCOPE_LISTED)
  return commands;
}

std::vector<Command> needed_commands(const std::vector<std::string>& words) {
  if (words.empty()) return all_commands();
  if (words.size() == 1 && (words[0] == "--version" || words[0] == "-V")) return {};
#define ALPHASCOPE_NAMED(name) \
  if (words[0] == #name) return {name##_command()};
  ALPHASCOPE_COMMANDS(ALPHASCOPE_NAMED)
  return all_commands();
}

}  // namespace alphascope::cli
