// SPDX-License-Identifier: GPL-3.0-or-later
// The options of both programs for ids in place of files.
#pragma once

#include "app/options/option_table.hpp"

namespace alphascope {

Option offline_option(bool& offline);
Option fetch_again_option(bool& fetch_again);

inline constexpr const char* kOfflineAndAgain = "--offline and --fetch-again exclude each other.";

}  // namespace alphascope
