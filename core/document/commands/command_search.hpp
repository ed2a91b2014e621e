// SPDX-License-Identifier: GPL-3.0-or-later
// Finds commands by typed text, for the command palette.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

class Commands;
struct CommandSpec;

struct CommandMatch {
  const CommandSpec* command = nullptr;
  std::string arguments;  // text typed after the name: "3.2" of "alpha 3.2"
};

// Best matches first; equal ones in the order of the list. Each typed word must occur in the title
// or the id, or begin a word of the help or of a synonym. Or its letters must occur in this order
// in title or id ("rv": Reset view). Words after the match may be arguments, if the command takes
// them. Without text all commands match.
std::vector<CommandMatch> search_commands(const Commands& commands, std::string_view typed);

}  // namespace alphascope
