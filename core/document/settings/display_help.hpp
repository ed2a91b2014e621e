// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of the display as a text, for people and for the docs.
#pragma once

#include <string>

namespace alphascope {

// A heading and a line for each setting: title, values, default, command, option and key in session
// files, with at least two blanks between; "-" where there is none.
std::string display_help();

}  // namespace alphascope
