// What the program can do, as one list: menus, keys, palette and scripts are made from it.
#pragma once

#include "core/document/commands/commands.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// The commands act on the state alone, as the panels do; the program takes the requests that they
// leave there with the next frame. The state must outlive them.
void add_program_commands(Commands& commands, ViewState& state);

}  // namespace alphascope
