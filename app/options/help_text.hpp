// --help, from the table of options.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

// Of the program, or with `command` of that one.
std::string help_text(const OptionProgram& program, const OptionCommand* command);

// "alphascope-cli compute [OPTIONS] FILE..."
std::string usage_line(const OptionProgram& program, const OptionCommand* command);

}  // namespace alphascope
