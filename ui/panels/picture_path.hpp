// Where a picture, a table or a session is saved to.
#pragma once

#include <filesystem>
#include <string>

namespace alphascope {

// The whole path of what was typed, with this ending (".csv"), which it gets when it has another.
std::filesystem::path path_to_save(const std::string& typed, const std::string& ending);
// The whole path, ending in ".png": pictures are PNG files whatever one calls them.
std::filesystem::path picture_path(const std::string& typed);
// The same, ending in ".json".
std::filesystem::path session_path(const std::string& typed);

}  // namespace alphascope
