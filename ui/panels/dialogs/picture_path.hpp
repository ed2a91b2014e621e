// Where a picture, a table or a session is saved to.
#pragma once

#include <filesystem>
#include <string>

namespace alphascope {

// The whole path of what was typed, without blanks at its ends: "~" is the home folder, and all
// else is in `base`, or in the present folder. Empty where nothing was typed.
std::filesystem::path typed_path(const std::string& typed, const std::filesystem::path& base = {});

// The same with this ending (".csv"), where a name has none. One with another ending stays, and
// fault_of_ending() says what is wrong with it. A folder stays a folder.
std::filesystem::path path_to_save(const std::string& typed, const std::string& ending);

inline constexpr const char* kPictureEnding = ".png";
inline constexpr const char* kSessionEnding = ".json";

}  // namespace alphascope
