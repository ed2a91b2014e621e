// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program, as one list. Menus, keys, the palette and scripts are made from it.
#pragma once

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class PanelSet;

// Adds all commands, with those of the panels. They change settings in `state`, as panels do, or
// make calls of `ask`. All arguments must outlive the commands.
void add_program_commands(Commands& commands, ViewState& state, const Calls& ask, PanelSet& panels);

}  // namespace alphascope
