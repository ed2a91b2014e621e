// SPDX-License-Identifier: GPL-3.0-or-later
// Shortens texts in their middle, at boundaries of UTF-8 characters.
#include "ui/fitted_text.hpp"

namespace alphascope {

std::string fitted_text(const std::string& text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return text;
  const auto boundary = [&text](std::size_t i) {  // not inside a UTF-8 sequence
    while (i > 0 && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80) --i;
    return i;
  };
  for (std::size_t keep = text.size(); keep > 4; --keep) {
    const std::size_t head = boundary(keep / 2), tail = boundary(text.size() - keep / 2);
    std::string cut = text.substr(0, head) + "…" + text.substr(tail);
    if (width_of(cut) <= width) return cut;
  }
  return "…";
}

}  // namespace alphascope
