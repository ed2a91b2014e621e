// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that a text is one well-formed XML element. It knows elements, attributes in double quotes
// and the five entities, but no comments and no CDATA.
#pragma once

#include <string>
#include <vector>

namespace alphascope::test {

inline bool entities_known(const std::string& text) {
  for (std::size_t k = text.find('&'); k != std::string::npos; k = text.find('&', k + 1)) {
    bool known = false;
    for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      known |= text.compare(k, std::char_traits<char>::length(entity), entity) == 0;
    }
    if (!known) return false;
  }
  return true;
}

// Empty when the text is well-formed, else the error.
inline std::string xml_error(std::string text) {
  if (text.starts_with("<?xml ")) text.erase(0, text.find("?>") + 2);
  std::vector<std::string> open;
  bool seen = false;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t tag = text.find('<', k);
    const std::string between = text.substr(k, tag == std::string::npos ? tag : tag - k);
    if (!entities_known(between)) return "an unescaped & in '" + between + "'";
    if (between.find('>') != std::string::npos) return "a stray > in '" + between + "'";
    if (open.empty() && between.find_first_not_of(" \n\t") != std::string::npos) {
      return "text outside: '" + between + "'";
    }
    if (tag == std::string::npos) break;
    std::size_t end = tag + 1;
    for (bool quoted = false; end < text.size() && (quoted || text[end] != '>'); ++end) {
      if (text[end] == '"')
        quoted = !quoted;
      else if (text[end] == '<')
        return "a < inside of a tag";
    }
    if (end >= text.size()) return "a tag without end";
    const std::string inside = text.substr(tag + 1, end - tag - 1);
    if (!entities_known(inside)) return "an unescaped & in <" + inside + ">";
    const std::string name = inside.substr(0, inside.find_first_of(" /", 1));
    if (inside.starts_with("/")) {
      if (open.empty() || "/" + open.back() != inside) return "unexpected <" + inside + ">";
      open.pop_back();
    } else if (!inside.ends_with("/")) {
      if (open.empty() && seen) return "a second root";
      open.push_back(name);
      seen = true;
    }
    k = end + 1;
  }
  if (!open.empty()) return "<" + open.back() + "> is not closed";
  return seen ? "" : "no element";
}

}  // namespace alphascope::test
