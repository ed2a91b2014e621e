// SPDX-License-Identifier: GPL-3.0-or-later
// Scans JSON without recursion, so deep nesting cannot overflow the stack. Each function takes one
// step a character.
#include "core/document/session/json_place.hpp"

#include <algorithm>

namespace alphascope {
namespace {

class Scanner {
 public:
  explicit Scanner(std::string_view json) : json_(json) {}

  std::size_t at() const { return at_; }
  void skip_blanks() {
    while (at_ < json_.size() && (is(' ') || is('\n') || is('\r') || is('\t') || is('\xEF') ||
                                  is('\xBB') || is('\xBF'))) {
      ++at_;
    }
  }
  bool is(char c) const { return at_ < json_.size() && json_[at_] == c; }
  bool take(char c) {
    skip_blanks();
    if (!is(c)) return false;
    ++at_;
    return true;
  }
  // Takes a string with its quotes.
  std::string_view take_string() {
    const std::size_t first = at_;
    if (is('"')) ++at_;
    while (at_ < json_.size() && !is('"')) at_ += is('\\') ? 2 : 1;
    at_ = std::min(at_ + 1, json_.size());
    return json_.substr(first, at_ - first);
  }
  // Skips a value, up to the comma or bracket after it.
  void skip_value() {
    std::size_t depth = 0;
    for (; at_ < json_.size(); ++at_) {
      if (is('"')) {
        take_string();
        --at_;
      } else if (is('{') || is('[')) {
        ++depth;
      } else if (is('}') || is(']') || is(',')) {
        if (depth == 0) return;
        if (!is(',')) --depth;
      }
    }
  }
  // Moves to the value of the last member with this name, because messages about a name that occurs
  // twice are about the second one. Returns false if there is none.
  bool enter_member(const std::string& name) {
    std::size_t found = std::string_view::npos;
    if (!take('{')) return false;
    for (skip_blanks(); is('"'); skip_blanks()) {
      const std::string_view key = take_string();
      if (!take(':')) break;
      skip_blanks();
      if (key.size() == name.size() + 2 && key.substr(1, name.size()) == name) found = at_;
      skip_value();
      if (!take(',')) break;
    }
    if (found == std::string_view::npos) return false;
    at_ = found;
    return true;
  }
  bool enter_element(std::size_t index) {
    if (!take('[')) return false;
    for (std::size_t i = 0; i < index; ++i) {
      skip_value();
      if (!take(',')) return false;
    }
    skip_blanks();
    return true;
  }

 private:
  std::string_view json_;
  std::size_t at_ = 0;
};

}  // namespace

std::string place_text(const JsonPlace& place) {
  std::string text;
  for (const std::string& step : place) text += (text.empty() ? "" : ".") + step;
  return text;
}

std::size_t line_at(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::size_t line_of(std::string_view json, const JsonPlace& place) {
  Scanner scanner(json);
  for (const std::string& step : place) {
    scanner.skip_blanks();
    const bool inside =
        scanner.is('[') ? scanner.enter_element(std::stoul(step)) : scanner.enter_member(step);
    if (!inside) break;  // a name with escapes: uses the line of the enclosing value
  }
  return line_at(json, scanner.at());
}

bool nested_deeper_than(std::string_view json, std::size_t limit, std::size_t& offset) {
  std::size_t depth = 0;
  bool inside_string = false;
  for (offset = 0; offset < json.size(); ++offset) {
    const char c = json[offset];
    if (inside_string) {
      if (c == '\\') ++offset;
      inside_string = c != '"';
    } else if (c == '"') {
      inside_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > limit) return true;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return false;
}

}  // namespace alphascope
