// SPDX-License-Identifier: GPL-3.0-or-later
// Shortens texts in their middle or at their end, at boundaries of UTF-8 characters.
#include "ui/fitted_text.hpp"

#include "core/text/utf8.hpp"

namespace alphascope {

std::string fitted_text(const std::string& text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return text;
  const auto boundary = [&text](std::size_t i) {  // not inside a UTF-8 sequence
    while (i > 0 && i < text.size() && continues_character(text[i])) --i;
    return i;
  };
  for (std::size_t keep = text.size(); keep > 4; --keep) {
    const std::size_t head = boundary(keep / 2), tail = boundary(text.size() - keep / 2);
    std::string cut = text.substr(0, head) + "…" + text.substr(tail);
    if (width_of(cut) <= width) return cut;
  }
  return "…";
}

std::string fitted_beginning(const std::string& text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return text;
  std::string kept = text;
  while (!kept.empty() && width_of(kept + "…") > width) {
    while (continues_character(kept.back()) && kept.size() > 1) kept.pop_back();
    kept.pop_back();
  }
  return kept + "…";
}

}  // namespace alphascope
