// SPDX-License-Identifier: GPL-3.0-or-later
// Markdown as blocks of text: headings, paragraphs, lists, code, tables and pictures. Any text can
// be read; marks without a meaning stay in the text. HTML is left out, except line breaks (<br>).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// A piece of a text in one style. A line end in it is a line break.
struct MarkdownSpan {
  std::string text;
  bool strong = false, emphasis = false, code = false;
  std::string link = {};  // the target, as written; empty: none

  bool operator==(const MarkdownSpan&) const = default;
};
using MarkdownText = std::vector<MarkdownSpan>;

enum class MarkdownKind : std::uint8_t { heading, paragraph, item, code, row, picture };

struct MarkdownBlock {
  MarkdownKind kind = MarkdownKind::paragraph;
  std::size_t line = 0;  // its first line, from 1
  // Of a heading 1 to 6; of an item of a list its depth, from 0.
  int level = 0;
  std::string marker = {};  // of an item: "•" or its number, such as "3."
  // The cells of a row, otherwise one text. Lines of code are one span with line ends.
  std::vector<MarkdownText> cells = {};
  bool head = false;         // the first row of a table, with the titles of its columns
  std::string picture = {};  // of a picture: its file as written; its text describes it
};

// CommonMark with GitHub's tables. Texts have at most 4 GB.
std::vector<MarkdownBlock> read_markdown(std::string_view text);

std::string plain_text(const MarkdownText& text);
std::string plain_text(const MarkdownBlock& block);  // cells are separated by tabs

// The anchor of a heading, as GitHub makes it: "The `slider` (α)" has "the-slider-α".
std::string markdown_anchor(std::string_view heading);

}  // namespace alphascope
