// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts with which shells complete commands, options and values, made from the table of options.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

// The script for "bash", "zsh" or "fish"; empty for another shell.
std::string completion_script(const OptionProgram& program, const std::string& shell);

}  // namespace alphascope
