// Whether the name of an output ends as its format does: a PNG file named a.jpg deceives whoever
// opens it.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace alphascope {

// In small letters, with the point, of whatever case in the name: ".png"; "" when there is none. A
// number is none: "areas_at_1.4".
std::string output_ending(const std::filesystem::path& path);

// Empty when the name has one of these endings, or none at all; what is there and no ordinary file
// (/dev/null, a pipe) may be called anything. Else what is wrong, without full stop: "the name must
// end in .ply or .glb, not .jpg".
std::string fault_of_ending(const std::filesystem::path& path,
                            std::span<const std::string_view> endings);
inline std::string fault_of_ending(const std::filesystem::path& path,
                                   std::initializer_list<std::string_view> endings) {
  return fault_of_ending(path, std::span(endings.begin(), endings.size()));
}

}  // namespace alphascope
