// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the lines and fields of a loaded text, with line numbers for messages.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace alphascope {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Lines end with LF, CRLF, LFCR or the end of the text. The line ends are not part of them.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const void* end = std::memchr(rest_.data(), '\n', rest_.size());
    const std::size_t length =
        end ? static_cast<std::size_t>(static_cast<const char*>(end) - rest_.data()) : rest_.size();
    line = rest_.substr(0, length);
    rest_.remove_prefix(end ? length + 1 : length);
    cut_ = !end;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.empty() && line.front() == '\r') line.remove_prefix(1);
    ++number_;
    return true;
  }

  std::size_t number() const { return number_; }  // of the last line, from 1
  std::size_t bytes_left() const { return rest_.size(); }
  // True if the last line had no line end: the file may be truncated there.
  bool cut() const { return cut_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  bool cut_ = false;
};

// Takes the next field between blanks off the front of `line`; empty at its end.
inline std::string_view next_field(std::string_view& line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  std::size_t length = 0;
  while (length < line.size() && !is_blank(line[length])) ++length;
  const std::string_view field = line.substr(0, length);
  line.remove_prefix(length);
  return field;
}

// Parses the whole text, which has no blanks around it, as a number. `number` may change on
// failure.
template <class Number>
bool parse_whole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace alphascope
