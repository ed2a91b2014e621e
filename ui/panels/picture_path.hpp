// Where a picture is saved to.
#pragma once

#include <filesystem>
#include <string>

namespace alphascope {

// The whole path, ending in ".png": pictures are PNG files whatever one calls them.
std::filesystem::path picture_path(const std::string& typed);

}  // namespace alphascope
