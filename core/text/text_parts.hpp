// SPDX-License-Identifier: GPL-3.0-or-later
// Splits a text at separators, or into words at blanks. Streams are not used: a stream that runs
// out of memory behaves as if the text ended, and the rest would be lost without a message.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// "a,b,,c" has four parts, "a," has one, "" has none: an empty part at the end does not count.
inline std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return parts;
}

// Words between any number of blanks, tabs and line ends; no word is empty.
inline std::vector<std::string> words_of(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\n\r\v\f";
  std::vector<std::string> words;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == text.npos) return words;
    text.remove_prefix(begin);
    const std::size_t end = text.find_first_of(kBlanks);
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end);
  }
}

}  // namespace alphascope
