// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as Markdown. Every text can be read; its blocks are in the order of their lines,
// and their texts add no bytes but bullets and what joins lines.
#include <cstdlib>
#include <string_view>

#include "core/document/guide/markdown.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using alphascope::MarkdownKind;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::size_t line = 0, bytes = 0;
  for (const alphascope::MarkdownBlock& block : alphascope::read_markdown(text)) {
    require(block.line >= line);
    line = block.line;
    const bool row = block.kind == MarkdownKind::row;
    require(row || block.cells.size() == 1);
    require(block.kind != MarkdownKind::code || block.cells[0].size() == 1);
    require(block.kind != MarkdownKind::heading || (block.level >= 1 && block.level <= 6));
    require((block.kind == MarkdownKind::item) == !block.marker.empty());
    bytes += plain_text(block).size();
    alphascope::markdown_anchor(plain_text(block));
    for (const alphascope::MarkdownText& cell : block.cells) {
      for (const alphascope::MarkdownSpan& span : cell)
        require(row || !span.text.empty() || span.code);
    }
  }
  // A byte 0 becomes a character of three bytes, and a tab before code up to four spaces.
  require(bytes <= 4 * size);
  return 0;
}
