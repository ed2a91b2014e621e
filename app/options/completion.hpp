// Scripts that let shells complete commands, options and values, from the table of options.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

// For "bash", "zsh" or "fish"; for another shell, nothing.
std::string completion_script(const OptionProgram& program, const std::string& shell);

}  // namespace alphascope
