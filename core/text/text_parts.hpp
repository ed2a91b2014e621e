// The parts of a text between separators, and its words between blanks. Not by streams: one that
// runs out of memory ends as if the text did, and what follows would be left out without a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// "a,b,,c" has four, "a," one, "" none: nothing is behind the last separator.
inline std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return parts;
}

// Between blanks, tabs and line ends, however many; none is empty.
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
