// SPDX-License-Identifier: GPL-3.0-or-later
// What the manual pages of both programs tell beside options: files, variables of the environment,
// other pages. One list for both.
#pragma once

#include "app/options/option_table.hpp"

namespace alphascope {

// Fills `date`, `files`, `environment` and `see_also` of a program.
void add_manual_entries(OptionProgram& program);

}  // namespace alphascope
