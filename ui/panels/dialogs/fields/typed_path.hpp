// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that users type to save pictures, tables and sessions.
#pragma once

#include <filesystem>
#include <string>

namespace alphascope {

// Returns the whole path of the typed text, without blanks at its ends. "~" is the home folder.
// Relative paths start in `base`, or in the present folder if `base` is empty. The result is empty
// if nothing was typed.
std::filesystem::path typed_path(const std::string& typed, const std::filesystem::path& base = {});

// Returns the same path, with this ending (".csv") if the name has none. A name with another ending
// stays, and fault_of_ending() names the fault. The path of a folder stays.
std::filesystem::path path_to_save(const std::string& typed, const std::string& ending);

inline constexpr const char* kPictureEnding = ".png";
inline constexpr const char* kSessionEnding = ".json";

}  // namespace alphascope
