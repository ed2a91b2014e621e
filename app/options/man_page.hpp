// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page, made from the table of options.
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

// The page in the language of man(7), as UTF-8.
std::string man_page(const OptionProgram& program);

}  // namespace alphascope
