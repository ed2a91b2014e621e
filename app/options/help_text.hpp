// SPDX-License-Identifier: GPL-3.0-or-later
// The text of --help, made from the table of options.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

// The help of the program or, with `command`, of this command.
std::string help_text(const OptionProgram& program, const OptionCommand* command);

// For example "alphascope-cli compute [OPTIONS] FILE..."
std::string usage_line(const OptionProgram& program, const OptionCommand* command);

}  // namespace alphascope
