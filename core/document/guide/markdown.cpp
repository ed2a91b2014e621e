// SPDX-License-Identifier: GPL-3.0-or-later
// Makes blocks of what the parser MD4C reports. Only this source uses it.
#include "core/document/guide/markdown.hpp"

#include <md4c.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <new>
#include <utility>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

bool is_punctuation(char c) {
  return c > ' ' && c < 127 && !(c >= '0' && c <= '9') && lower_case(c) == upper_case(c);
}

std::string_view text_of(const MD_ATTRIBUTE& attribute) {
  return {attribute.text, attribute.size};
}

// The character of an entity; of a rare one the entity as it is written.
std::string_view character_of(std::string_view entity) {
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&nbsp;", "\u00A0"}};
  for (const auto& [name, character] : kKnown) {
    if (entity == name) return character;
  }
  return entity;
}

// Takes the parser's events in the order of the text.
class BlockMaker {
 public:
  explicit BlockMaker(std::string_view text) : text_(text) {}

  void enter(MD_BLOCKTYPE type, const void* detail) {
    switch (type) {
      case MD_BLOCK_H:
        begin(MarkdownKind::heading).level =
            static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level);
        break;
      case MD_BLOCK_P:  // the first paragraph of an item belongs to the item
        if (!std::exchange(item_begins_, false)) begin(MarkdownKind::paragraph);
        pictures_ = others_ = 0;
        break;
      case MD_BLOCK_CODE:
        begin(MarkdownKind::code);
        break;
      case MD_BLOCK_UL:
        lists_.push_back({});
        break;
      case MD_BLOCK_OL: {
        const auto& list = *static_cast<const MD_BLOCK_OL_DETAIL*>(detail);
        lists_.push_back({list.start, list.mark_delimiter});
        break;
      }
      case MD_BLOCK_LI:
        begin_item();
        break;
      case MD_BLOCK_THEAD:
        in_head_ = true;
        break;
      case MD_BLOCK_TR:
        begin(MarkdownKind::row).head = in_head_;
        blocks_.back().cells.clear();
        break;
      case MD_BLOCK_TH:
      case MD_BLOCK_TD:
        blocks_.back().cells.emplace_back();
        break;
      default:
        break;
    }
  }

  void leave(MD_BLOCKTYPE type) {
    switch (type) {
      case MD_BLOCK_P:  // a paragraph that is one picture becomes a picture
        if (pictures_ == 1 && others_ == 0 && blocks_.back().kind == MarkdownKind::paragraph) {
          blocks_.back().kind = MarkdownKind::picture;
          blocks_.back().picture = picture_;
        }
        takes_text_ = false;
        break;
      case MD_BLOCK_H:
        takes_text_ = false;
        break;
      case MD_BLOCK_CODE: {
        takes_text_ = false;
        MarkdownText& lines = blocks_.back().cells[0];
        if (lines.empty()) lines.push_back({.text = {}, .code = true});
        if (lines[0].text.ends_with('\n')) lines[0].text.pop_back();
        break;
      }
      case MD_BLOCK_UL:
      case MD_BLOCK_OL:
        lists_.pop_back();
        break;
      case MD_BLOCK_LI:
        item_begins_ = takes_text_ = false;
        break;
      case MD_BLOCK_THEAD:
        in_head_ = false;
        break;
      case MD_BLOCK_TR: {  // the parser fills a short row with empty cells
        std::vector<MarkdownText>& cells = blocks_.back().cells;
        while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
        takes_text_ = false;
        break;
      }
      default:
        break;
    }
  }

  void enter(MD_SPANTYPE type, const void* detail) {
    if (type == MD_SPAN_EM) ++emphasis_;
    if (type == MD_SPAN_STRONG) ++strong_;
    if (type == MD_SPAN_CODE) code_ = true;
    if (type == MD_SPAN_A) link_ = text_of(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
    if (type == MD_SPAN_IMG && in_picture_++ == 0) {
      ++pictures_;
      picture_ = text_of(static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src);
    }
  }

  void leave(MD_SPANTYPE type) {
    if (type == MD_SPAN_EM) --emphasis_;
    if (type == MD_SPAN_STRONG) --strong_;
    if (type == MD_SPAN_CODE) code_ = false;
    if (type == MD_SPAN_A) link_.clear();
    if (type == MD_SPAN_IMG) --in_picture_;
  }

  void take(MD_TEXTTYPE type, std::string_view text) {
    if (type == MD_TEXT_HTML) {  // comments and the like are left out
      if (text.starts_with("<br") && takes_text_) add("\n");
      return;
    }
    if (type == MD_TEXT_BR) text = "\n";
    if (type == MD_TEXT_SOFTBR) text = " ";
    if (type == MD_TEXT_ENTITY) text = character_of(text);
    // The parser names no paragraph in a list without blank lines, as after code in its item.
    if (!takes_text_) begin(MarkdownKind::paragraph);
    item_begins_ = false;
    find_line(text);
    add(text);
    if (type == MD_TEXT_CODE && blocks_.back().kind == MarkdownKind::row) {
      // The backslash before a bar in a cell is for the table; the parser leaves it in code.
      std::string& code = blocks_.back().cells.back().back().text;
      for (std::size_t at = 0; (at = code.find("\\|", at)) != code.npos; ++at) code.erase(at, 1);
    }
  }

  std::vector<MarkdownBlock> blocks() && { return std::move(blocks_); }

  // The first exception of a call by the parser, which is C and must not be left by one.
  std::exception_ptr failure;

 private:
  struct List {
    unsigned next = 0;
    char delimiter = 0;  // 0: without numbers
  };

  MarkdownBlock& begin(MarkdownKind kind) {
    item_begins_ = false;
    blocks_.push_back({.kind = kind, .line = line_, .cells = {{}}});
    line_is_open_ = takes_text_ = true;
    return blocks_.back();
  }

  void begin_item() {
    constexpr std::size_t kDeepest = 8;
    List& list = lists_.back();
    MarkdownBlock& item = begin(MarkdownKind::item);
    item.level = static_cast<int>(std::min(lists_.size() - 1, kDeepest));
    item.marker = list.delimiter == 0 ? "•" : std::to_string(list.next++) + list.delimiter;
    item_begins_ = true;
  }

  // Pieces of the input tell the line of their block. The parser makes other pieces by itself.
  void find_line(std::string_view piece) {
    const bool of_input = std::less_equal<>()(text_.data(), piece.data()) &&
                          std::less<>()(piece.data(), text_.data() + text_.size());
    if (!line_is_open_ || !of_input) return;
    line_is_open_ = false;
    const auto at = static_cast<std::size_t>(piece.data() - text_.data());
    if (at < counted_) return;
    const auto begin = text_.begin();
    line_ += static_cast<std::size_t>(std::count(begin + static_cast<std::ptrdiff_t>(counted_),
                                                 begin + static_cast<std::ptrdiff_t>(at), '\n'));
    counted_ = at;
    blocks_.back().line = line_;
  }

  // Adds to the last span if that has the same style.
  void add(std::string_view piece) {
    if (blocks_.empty() || blocks_.back().cells.empty() || piece.empty()) return;
    MarkdownBlock& block = blocks_.back();
    if (in_picture_ == 0) ++others_;
    const bool code = code_ || block.kind == MarkdownKind::code;
    MarkdownText& spans = block.cells.back();
    const MarkdownSpan style{
        .text = {}, .strong = strong_ > 0, .emphasis = emphasis_ > 0, .code = code, .link = link_};
    const auto same = [&](const MarkdownSpan& s) {
      return s.strong == style.strong && s.emphasis == style.emphasis && s.code == style.code &&
             s.link == style.link;
    };
    if (spans.empty() || !same(spans.back())) spans.push_back(style);
    spans.back().text += piece;
  }

  const std::string_view text_;
  std::vector<MarkdownBlock> blocks_;
  std::vector<List> lists_;  // the outermost first
  bool item_begins_ = false, in_head_ = false, code_ = false;
  int emphasis_ = 0, strong_ = 0, in_picture_ = 0;
  std::size_t pictures_ = 0, others_ = 0;  // in the paragraph: pictures, and pieces beside them
  std::string link_, picture_;
  std::size_t line_ = 1, counted_ = 0;  // the line of text_[counted_]
  bool line_is_open_ = false;           // the line of the last block is not known yet
  bool takes_text_ = false;             // the last block has not ended
};

// Calls a function of the BlockMaker; the parser ends if it has failed.
template <class Function>
int guarded(void* maker, Function function) {
  auto& blocks = *static_cast<BlockMaker*>(maker);
  try {
    function(blocks);
    return 0;
  } catch (...) {
    blocks.failure = std::current_exception();
    return 1;
  }
}

}  // namespace

std::vector<MarkdownBlock> read_markdown(std::string_view text) {
  MD_PARSER parser{};
  parser.flags = MD_FLAG_TABLES;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* maker) {
    return guarded(maker, [&](BlockMaker& blocks) { blocks.enter(type, detail); });
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void*, void* maker) {
    return guarded(maker, [&](BlockMaker& blocks) { blocks.leave(type); });
  };
  parser.enter_span = [](MD_SPANTYPE type, void* detail, void* maker) {
    return guarded(maker, [&](BlockMaker& blocks) { blocks.enter(type, detail); });
  };
  parser.leave_span = [](MD_SPANTYPE type, void*, void* maker) {
    return guarded(maker, [&](BlockMaker& blocks) { blocks.leave(type); });
  };
  parser.text = [](MD_TEXTTYPE type, const char* piece, MD_SIZE size, void* maker) {
    return guarded(maker, [&](BlockMaker& blocks) { blocks.take(type, {piece, size}); });
  };
  // The parser reports a byte 0 in code twice.
  std::string readable;
  if (text.find('\0') != text.npos) {
    for (const char c : text) readable += c == '\0' ? std::string("\uFFFD") : std::string(1, c);
    text = readable;
  }
  BlockMaker blocks(text);
  const int failed = md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &blocks);
  if (blocks.failure) std::rethrow_exception(blocks.failure);
  if (failed != 0) throw std::bad_alloc();
  return std::move(blocks).blocks();
}

std::string plain_text(const MarkdownText& text) {
  std::string plain;
  for (const MarkdownSpan& span : text) plain += span.text;
  return plain;
}

std::string plain_text(const MarkdownBlock& block) {
  std::string plain;
  for (std::size_t n = 0; n < block.cells.size(); ++n) {
    if (n > 0) plain += '\t';
    plain += plain_text(block.cells[n]);
  }
  return plain;
}

std::string markdown_anchor(std::string_view heading) {
  // Dashes, quotes and dots of Unicode (U+2000 to U+206F) are dropped, as other punctuation is.
  const auto is_mark = [&](std::size_t at) {
    const std::string_view start = heading.substr(at, 2);
    return start == "\xE2\x80" || start == "\xE2\x81";
  };
  std::string anchor;
  for (std::size_t at = 0; at < heading.size(); at += is_mark(at) ? 3 : 1) {
    const char c = heading[at];
    const bool word = static_cast<unsigned char>(c) >= 0x80 || c == '-' || c == '_' ||
                      (c > ' ' && c < 127 && !is_punctuation(c));
    if (c == ' ') anchor += '-';
    if (word && !is_mark(at)) anchor += lower_case(c);
  }
  return anchor;
}

}  // namespace alphascope
