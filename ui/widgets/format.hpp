// SPDX-License-Identifier: GPL-3.0-or-later
// Formats times, bytes, shares and ratios for reading. Pure text, no ImGui.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace alphascope {

std::string with_separators(long long value);        // "58,674"
std::string milliseconds_text(double milliseconds);  // "0.042 ms", "12.3 ms", "1.24 s"
std::string bytes_text(std::size_t bytes);           // "340 MB"
// Memory of the whole window with an assembly's complex: at alpha 0, and the upper bound.
struct MemoryRange {
  std::uint64_t least = 0, most = 0;  // bytes
};
MemoryRange assembly_memory(std::uint64_t atoms);
std::string percent_text(double share);  // "37 %", of 0 to 1
std::string ratio_text(double ratio);    // "5,568×", "3.2×", "0.82×", "< 0.01×"

}  // namespace alphascope
