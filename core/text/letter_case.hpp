// SPDX-License-Identifier: GPL-3.0-or-later
// Upper and lower case of names, keywords and file endings. Only ASCII letters change, whatever the
// locale; bytes of other letters stay as they are.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

inline char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

inline char upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
}

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower_case(c);
  return result;
}

inline std::string upper_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper_case(c);
  return result;
}

}  // namespace alphascope
