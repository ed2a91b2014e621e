// SPDX-License-Identifier: GPL-3.0-or-later
// Tests blocks and styles of Markdown.
#include "core/document/guide/markdown.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace alphascope {
namespace {

using Kind = MarkdownKind;

// One letter for each block, with its text: "h1 Title", "p Text".
std::vector<std::string> outline(const std::string& text) {
  std::vector<std::string> lines;
  for (const MarkdownBlock& block : read_markdown(text)) {
    const std::string level = std::to_string(block.level), plain = plain_text(block);
    switch (block.kind) {
      case Kind::heading:
        lines.push_back("h" + level + " " + plain);
        break;
      case Kind::paragraph:
        lines.push_back("p " + plain);
        break;
      case Kind::item:
        lines.push_back(level + block.marker + " " + plain);
        break;
      case Kind::code:
        lines.push_back("c " + plain);
        break;
      case Kind::row:
        lines.push_back((block.head ? "t " : "r ") + plain);
        break;
      case Kind::picture:
        lines.push_back("i " + plain + " " + block.picture);
        break;
    }
  }
  return lines;
}

using Texts = std::vector<std::string>;

// The styles of a text that is one paragraph.
MarkdownText read_markdown_text(const std::string& text) {
  const std::vector<MarkdownBlock> blocks = read_markdown(text);
  return blocks.size() == 1 && blocks[0].cells.size() == 1 ? blocks[0].cells[0] : MarkdownText{};
}

TEST(Markdown, HasHeadingsAndParagraphs) {
  EXPECT_EQ(outline("# One\nText\ngoes on.\n\nMore.\r\n### Three\n"),
            (Texts{"h1 One", "p Text goes on.", "p More.", "h3 Three"}));
  EXPECT_EQ(outline("#no heading\n####### seven\n"), Texts{"p #no heading ####### seven"});
  EXPECT_EQ(outline(""), Texts{});
  EXPECT_EQ(outline("\n\n  \n"), Texts{});
}

TEST(Markdown, HasLists) {
  EXPECT_EQ(outline("- one\n- two\n  goes on\n  - deeper\n1. first\n12) twelfth\n"),
            (Texts{"0• one", "0• two goes on", "1• deeper", "01. first", "012) twelfth"}));
  EXPECT_EQ(outline("-no item\n1.5 is a number\n"), Texts{"p -no item 1.5 is a number"});
}

// Without blank lines the parser names no paragraphs, and their text is not that of the block
// before.
TEST(Markdown, TextAfterABlockInAnItemIsAParagraph) {
  EXPECT_EQ(outline("- one\n  ```\n  code\n  ```\n  after\n"),
            (Texts{"0• one", "c code", "p after"}));
  EXPECT_EQ(outline("-     code\n  *after*\n"), (Texts{"0• ", "c code", "p after"}));
  EXPECT_EQ(outline("- one\n  # head\n  after\n"), (Texts{"0• one", "h1 head", "p after"}));
  EXPECT_EQ(outline("- one\n  > quote\n- > quote\n"), (Texts{"0• one", "p quote", "0• quote"}));
}

TEST(Markdown, KeepsCodeAsItIs) {
  EXPECT_EQ(outline("Text:\n\n    a  b\n\n      * c\n\nMore\n    of it\n"),
            (Texts{"p Text:", "c a  b\n\n  * c", "p More of it"}));
  EXPECT_EQ(outline("````\n```\n# *x*\n\n```\n````\nEnd\n"),
            (Texts{"c ```\n# *x*\n\n```", "p End"}));
  EXPECT_EQ(outline("```sh\nopen"), Texts{"c open"});
}

TEST(Markdown, ReadsRowsOfTables) {
  EXPECT_EQ(outline("| a | b |\n|---|---|\n| `x\\|y` | 1<br>2 |\n| z |\n\nText\n"),
            (Texts{"t a\tb", "r x|y\t1\n2", "r z", "p Text"}));
  EXPECT_EQ(outline("| no | table |\n"), Texts{"p | no | table |"});
  const auto blocks = read_markdown("\n| a |\n|---|\n| *b* |\n");
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].line, 2u);
  EXPECT_EQ(blocks[1].line, 4u);
  EXPECT_EQ(blocks[1].cells, (std::vector<MarkdownText>{{{.text = "b", .emphasis = true}}}));
}

TEST(Markdown, ReplacesBytesOfValue0) {
  EXPECT_EQ(outline(std::string("a\0b\n\n```\n\0\0\n```\n", 16)),
            (Texts{"p a\uFFFDb", "c \uFFFD\uFFFD"}));
}

TEST(Markdown, HasPicturesAndNoComments) {
  EXPECT_EQ(outline("![A pocket](../a.png)\n\nSee ![it](b.png) here.\n"),
            (Texts{"i A pocket ../a.png", "p See it here."}));
  EXPECT_EQ(outline("<!-- made by\na script -->\nText <!-- no --> on\n"), Texts{"p Text  on"});
}

TEST(MarkdownText, HasStyles) {
  EXPECT_EQ(read_markdown_text("a **b *c*** `d *e*`"),
            (MarkdownText{{.text = "a "},
                          {.text = "b ", .strong = true},
                          {.text = "c", .strong = true, .emphasis = true},
                          {.text = " "},
                          {.text = "d *e*", .code = true}}));
  EXPECT_EQ(read_markdown_text("**`Ctrl+P` lists.**"),
            (MarkdownText{{.text = "Ctrl+P", .strong = true, .code = true},
                          {.text = " lists.", .strong = true}}));
  EXPECT_EQ(read_markdown_text("```` ``` ````"), (MarkdownText{{.text = "```", .code = true}}));
}

TEST(MarkdownText, LeavesOtherMarksAsText) {
  for (const char* text : {"2 * 3 * 4", "a*", "*a", "**a", "`a", "[a]", "[a](b", "a < b > c",
                           "snake_case_name", "x **y** z**"}) {
    const std::string plain = plain_text(read_markdown_text(text));
    EXPECT_EQ(plain, std::string(text) == "x **y** z**" ? "x y z**" : text);
  }
  EXPECT_EQ(plain_text(read_markdown_text("\\*a\\* \\[ \\x")), "*a* [ \\x");
}

TEST(MarkdownText, HasLinks) {
  EXPECT_EQ(read_markdown_text("see [the `page`](a.md#b), <https://a.org>."),
            (MarkdownText{{.text = "see "},
                          {.text = "the ", .link = "a.md#b"},
                          {.text = "page", .code = true, .link = "a.md#b"},
                          {.text = ", "},
                          {.text = "https://a.org", .link = "https://a.org"},
                          {.text = "."}}));
  EXPECT_EQ(plain_text(read_markdown_text("[](a.md)b")), "b");
}

TEST(MarkdownAnchor, IsThatOfGitHub) {
  EXPECT_EQ(markdown_anchor("Exports (`export -o`, Export…)"), "exports-export--o-export");
  EXPECT_EQ(markdown_anchor("B-factors of 1 model_a"), "b-factors-of-1-model_a");
}

}  // namespace
}  // namespace alphascope
