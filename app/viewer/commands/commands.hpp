// What the program can do, as one list: menus, keys, palette and scripts are made from it.
#pragma once

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// The commands change settings in the state, as the panels do, or ask the program by calls. Both
// must outlive them.
void add_program_commands(Commands& commands, ViewState& state, const Calls& ask);

}  // namespace alphascope
