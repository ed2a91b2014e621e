// SPDX-License-Identifier: GPL-3.0-or-later
// Tells sessions from other files by their names.
#pragma once

#include <filesystem>

namespace alphascope {

// Whether the name ends in .json. Names of molecules never do, so a faulty file with this ending
// gets the error messages of sessions.
bool looks_like_session(const std::filesystem::path& path);

}  // namespace alphascope
