// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the name of an output has an ending of its format. A PNG file named a.jpg would
// mislead its readers.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace alphascope {

// The ending in lower case with its point: ".png"; empty if there is none. A number does not count
// as an ending: "areas_at_1.4".
std::string output_ending(const std::filesystem::path& path);

// Empty if the name has one of these endings or none at all, or if a device or pipe of that name
// exists (/dev/null). Else the fault, without a full stop: "the name must end in .ply or .glb, not
// .jpg".
std::string fault_of_ending(const std::filesystem::path& path,
                            std::span<const std::string_view> endings);
inline std::string fault_of_ending(const std::filesystem::path& path,
                                   std::initializer_list<std::string_view> endings) {
  return fault_of_ending(path, std::span(endings.begin(), endings.size()));
}

}  // namespace alphascope
