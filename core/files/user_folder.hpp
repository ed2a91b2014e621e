// SPDX-License-Identifier: GPL-3.0-or-later
// The user's folders, as the XDG Base Directory Specification names them.
#pragma once

#include <filesystem>

namespace alphascope {

// The program's folder in that of the environment variable, else in `below_home` of the user's
// home: user_folder("XDG_CACHE_HOME", ".cache") is ~/.cache/alphascope. Empty if there is no home.
std::filesystem::path user_folder(const char* variable, const char* below_home);

}  // namespace alphascope
