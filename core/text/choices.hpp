// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a choice, as sentences name them.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

inline std::string in_quotes(std::string_view text) {
  return "\"" + std::string(text) + "\"";
}

// "a, b or c" for "a|b|c".
inline std::string in_words(std::string ids) {
  if (const std::size_t last = ids.rfind('|'); last != std::string::npos) {
    ids.replace(last, 1, " or ");
  }
  for (std::size_t at = 0; (at = ids.find('|', at)) != std::string::npos;) ids.replace(at, 1, ", ");
  return ids;
}

}  // namespace alphascope
