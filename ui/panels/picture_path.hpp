// Where a picture, a table or a session is saved to.
#pragma once

#include <filesystem>
#include <string>

namespace alphascope {

// The whole path of what was typed; with this ending (".csv"), where it has none. One with another
// ending stays, and fault_of_ending() says what is wrong with it.
std::filesystem::path path_to_save(const std::string& typed, const std::string& ending);

inline constexpr const char* kPictureEnding = ".png";
inline constexpr const char* kSessionEnding = ".json";

}  // namespace alphascope
