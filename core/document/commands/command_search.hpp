// Finds commands by what a person types of them: the command palette without its window.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/commands/commands.hpp"

namespace alphascope {

struct CommandMatch {
  const CommandSpec* command = nullptr;
  std::string arguments;  // what was typed behind the name: "3.2" of "alpha 3.2"
};

// Best first; equally good ones in the order of the list. Each typed word must begin a word of the
// title, the id, a synonym or the help, or its letters must come in this order in title or id
// ("rv": Reset view). What follows may be arguments, where the command takes them. Nothing typed:
// all.
std::vector<CommandMatch> search_commands(const Commands& commands, std::string_view typed);

}  // namespace alphascope
