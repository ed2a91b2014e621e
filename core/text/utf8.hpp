// SPDX-License-Identifier: GPL-3.0-or-later
// Where the characters of UTF-8 begin, and how many there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace alphascope {

// Whether the byte is in a character, but not its first.
constexpr bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

inline std::size_t character_count(std::string_view text) {
  return text.size() -
         static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

}  // namespace alphascope
