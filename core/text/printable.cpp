// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes UTF-8 and replaces characters that cannot be seen.
#include "core/text/printable.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool valid = true;  // valid UTF-8; an invalid byte is one character
};

// The first character of a text that is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {lead, 1, false};
  std::uint32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if (!continues_character(text[k])) return {lead, 1, false};
    code = (code << 6) | (byte(k) & 0x3Fu);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[bytes] || surrogate || code > 0x10FFFF) return {lead, 1, false};
  return {code, bytes, true};
}

// Control characters, and characters of Unicode that are not visible but control the text:
// directions, joiners, line and paragraph ends, byte order marks, annotations, tags.
bool is_hidden(std::uint32_t code) {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr Range kHidden[] = {{0x00, 0x1F},     {0x7F, 0x9F},      {0xAD, 0xAD},
                               {0x61C, 0x61C},   {0x180E, 0x180E},  {0x200B, 0x200F},
                               {0x2028, 0x202E}, {0x2060, 0x206F},  {0xFEFF, 0xFEFF},
                               {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};
  return std::any_of(std::begin(kHidden), std::end(kHidden),
                     [&](const Range& r) { return code >= r.first && code <= r.last; });
}

std::string hexadecimal(const char* pattern, std::uint32_t code) {
  char text[16];
  std::snprintf(text, sizeof text, pattern, static_cast<unsigned>(code));
  return text;
}

// Calls use(character, its bytes) for each character in turn.
template <class Use>
void for_each_character(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const Character c = first_character(text);
    use(c, text.substr(0, c.bytes));
    text.remove_prefix(c.bytes);
  }
}

}  // namespace

bool is_printable(std::string_view text) {
  bool good = true;
  for_each_character(text, [&](const Character& c, std::string_view) {
    good = good && c.valid && !is_hidden(c.code);
  });
  return good;
}

std::string printable(std::string_view text) {
  const bool plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (plain) return std::string(text);
  std::string result;
  for_each_character(text, [&](const Character& c, std::string_view bytes) {
    if (c.valid && c.code == '\t') {
      result += ' ';
    } else if (!c.valid || (is_hidden(c.code) && c.code < 0x80)) {
      result += hexadecimal("\\x%02X", c.code);
    } else if (is_hidden(c.code)) {
      result += hexadecimal("\\u%04X", c.code);
    } else {
      result += bytes;
    }
  });
  return result;
}

std::string printable_json(std::string_view json) {
  std::string result;
  for_each_character(json, [&](const Character& c, std::string_view bytes) {
    if (!c.valid || !is_hidden(c.code) || c.code < 0x20) {
      result += bytes;  // below a blank there are only line ends between the values
    } else if (c.code < 0x10000) {
      result += hexadecimal("\\u%04x", c.code);
    } else {
      result += hexadecimal("\\u%04x", 0xD800 + ((c.code - 0x10000) >> 10));
      result += hexadecimal("\\u%04x", 0xDC00 + (c.code & 0x3FF));
    }
  });
  return result;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string result(text.substr(0, kLongest));
  if (text.size() > kLongest) {
    // Do not cut a UTF-8 character in half.
    while (!result.empty() && continues_character(result.back())) result.pop_back();
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0xC0) result.pop_back();
    return printable(result) + "…";
  }
  return printable(result);
}

}  // namespace alphascope
