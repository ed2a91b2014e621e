// SPDX-License-Identifier: GPL-3.0-or-later
// Reads blocks line by line, and styles character by character. Its time is about linear in the
// text: links have a limited length, and only backquotes in many different numbers take longer.
#include "core/text/markdown.hpp"

#include <algorithm>
#include <utility>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kNone = std::string_view::npos;
constexpr std::size_t kLongestLink = 1000;  // bytes of its text and its target together

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

bool is_punctuation(char c) {
  return c > ' ' && c < 127 && !(c >= '0' && c <= '9') && lower_case(c) == upper_case(c);
}

// --- styles in a text

class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  MarkdownText read() {
    while (at_ < text_.size()) step();
    return std::move(spans_);
  }

 private:
  char next(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  // Adds to the last span if that has the same style.
  void add(std::string_view piece, bool code = false) {
    if (piece.empty()) return;
    if (spans_.empty() || spans_.back().strong != strong_ || spans_.back().emphasis != emphasis_ ||
        spans_.back().code != code || spans_.back().link != link_) {
      spans_.push_back({{}, strong_, emphasis_, code, link_});
    }
    spans_.back().text += piece;
  }

  void step() {
    const char c = text_[at_];
    if (at_ == link_end_) return end_link();
    if (c == '\\' && is_punctuation(next(1))) {
      add(text_.substr(at_ + 1, 1));
      at_ += 2;
    } else if (c == '`') {
      read_code();
    } else if (c == '*') {
      read_star();
    } else if (c == '<' && read_angle()) {
    } else if ((c == '[' || (c == '!' && next(1) == '[')) && link_.empty() && begin_link()) {
    } else {
      add(text_.substr(at_, 1));
      ++at_;
    }
  }

  // Code lies between two runs of as many backquotes.
  void read_code() {
    const std::size_t run = std::min(text_.find_first_not_of('`', at_), text_.size()) - at_;
    for (std::size_t i = at_ + run; (i = text_.find('`', i)) != kNone;) {
      const std::size_t end = std::min(text_.find_first_not_of('`', i), text_.size());
      if (end - i == run) {
        std::string_view code = text_.substr(at_ + run, i - at_ - run);
        const bool padded = code.size() > 2 && code.front() == ' ' && code.back() == ' ' &&
                            code.find_first_not_of(' ') != kNone;
        if (padded) code = code.substr(1, code.size() - 2);
        add(code, true);
        at_ = end;
        return;
      }
      i = end;
    }
    add(text_.substr(at_, run));
    at_ += run;
  }

  // Stars are marks of a style if a word follows, or precedes the end. Other stars are text.
  void read_star() {
    const std::size_t count = next(1) == '*' ? 2 : 1;
    bool& style = count == 2 ? strong_ : emphasis_;
    const bool after_blank = at_ == 0 || is_blank(text_[at_ - 1]);
    const char behind = next(count);
    const bool opens = !style && behind != '\0' && !is_blank(behind) && closes_later(count);
    const bool closes = style && !after_blank;
    if (opens || closes) {
      style = !style;
    } else {
      add(text_.substr(at_, count));
    }
    at_ += count;
  }

  // Whether stars after this mark can end it. If there are none, there are none after later marks.
  bool closes_later(std::size_t count) {
    bool& none = count == 2 ? no_strong_end_ : no_emphasis_end_;
    if (none) return false;
    for (std::size_t i = at_ + count + 1; (i = text_.find('*', i)) != kNone;) {
      const std::size_t end = std::min(text_.find_first_not_of('*', i), text_.size());
      const bool enough = count == 2 ? end - i >= 2 : (end - i) % 2 == 1;
      if (enough && !is_blank(text_[i - 1])) return true;
      i = end;
    }
    none = true;
    return false;
  }

  // <br>, comments, and addresses in angle brackets.
  bool read_angle() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--")) {
      const std::size_t end = rest.find("-->");
      at_ = end == kNone ? text_.size() : at_ + end + 3;
      return true;
    }
    for (const std::string_view mark : {"<br>", "<br/>", "<br />"}) {
      if (!rest.starts_with(mark)) continue;
      add("\n");
      at_ += mark.size();
      return true;
    }
    if (!rest.starts_with("<https://") && !rest.starts_with("<http://")) return false;
    const std::size_t end = rest.substr(0, kLongestLink).find('>');
    if (end == kNone) return false;
    const std::string_view address = rest.substr(1, end - 1);
    const std::string outer = std::exchange(link_, std::string(address));
    add(address);
    link_ = outer;
    at_ += end + 1;
    return true;
  }

  // [text](target); of a picture amid a text only its description stays.
  bool begin_link() {
    const bool picture = text_[at_] == '!';
    const std::size_t begin = at_ + (picture ? 2 : 1);
    const std::string_view near = text_.substr(begin, kLongestLink);
    const std::size_t close = near.find("](");
    if (close == kNone) return false;
    const std::size_t end = near.find(')', close + 2);
    if (end == kNone) return false;
    at_ = begin;
    link_end_ = begin + close;
    after_link_ = begin + end + 1;
    if (!picture) link_ = trimmed(near.substr(close + 2, end - close - 2));
    if (link_end_ == begin) end_link();
    return true;
  }

  void end_link() {
    at_ = after_link_;
    link_.clear();
    link_end_ = kNone;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t link_end_ = kNone, after_link_ = 0;
  bool strong_ = false, emphasis_ = false;
  bool no_strong_end_ = false, no_emphasis_end_ = false;
  std::string link_;
  MarkdownText spans_;
};

// --- blocks

std::size_t indent_of(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// The backquotes that begin or end lines of code; empty: the line is another one.
std::string_view fence_of(std::string_view line) {
  const std::string_view text = trimmed(line);
  const std::size_t run = std::min(text.find_first_not_of('`'), text.size());
  return run >= 3 ? text.substr(0, run) : std::string_view();
}

// "## Title" has level 2; 0: no heading.
int heading_level(std::string_view line) {
  const std::size_t run = std::min(line.find_first_not_of('#'), line.size());
  const bool heading = run >= 1 && run <= 6 && run < line.size() && is_blank(line[run]);
  return heading ? static_cast<int>(run) : 0;
}

struct Marker {
  std::string shown;     // empty: the line begins no item
  std::size_t size = 0;  // with the blanks behind it
};

Marker marker_of(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && end < 9 && text[end] >= '0' && text[end] <= '9') ++end;
  const bool number = end > 0 && end < text.size() && (text[end] == '.' || text[end] == ')');
  const bool bullet = end == 0 && !text.empty() && (text[0] == '-' || text[0] == '*');
  if (!number && !bullet) return {};
  ++end;
  const std::string shown = number ? std::string(text.substr(0, end)) : "•";
  const std::size_t begin = text.find_first_not_of(' ', end);
  if (begin == kNone || begin == end) return {};
  return {shown, begin};
}

bool is_row(std::string_view line) {
  return trimmed(line).starts_with('|');
}

// "|---|:--|" below the titles of a table.
bool is_rule_of_table(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.starts_with('|') && text.find('-') != kNone &&
         text.find_first_not_of("|-: ") == kNone;
}

// Splits a row at its bars. A bar after a backslash is text, in code as well.
std::vector<MarkdownText> cells_of(std::string_view line) {
  std::string_view row = trimmed(line);
  row.remove_prefix(1);
  std::vector<MarkdownText> cells;
  std::string cell;
  const auto end_cell = [&] {
    cells.push_back(read_markdown_text(trimmed(cell)));
    cell.clear();
  };
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '\\' && i + 1 < row.size() && row[i + 1] == '|') {
      cell += row[++i];
    } else if (row[i] == '|') {
      end_cell();
    } else {
      cell += row[i];
    }
  }
  if (!trimmed(cell).empty()) end_cell();
  return cells;
}

// The block that is being read.
enum class Open : std::uint8_t { nothing, paragraph, item, code, table };

class BlockReader {
 public:
  explicit BlockReader(std::string_view text) : rest_(text) {}

  std::vector<MarkdownBlock> read() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(end == kNone ? rest_.size() : end + 1);
      if (line.ends_with('\r')) line.remove_suffix(1);
      ++line_;
      take(line);
    }
    end_block();
    return std::move(blocks_);
  }

 private:
  // A row is the first of a table if a rule follows it.
  bool begins_table(std::string_view line) const {
    return is_row(line) && is_rule_of_table(rest_.substr(0, rest_.find('\n')));
  }

  void take(std::string_view line) {
    if (!fence_.empty()) return take_fenced(line);
    const std::string_view text = trimmed(line);
    const std::size_t indent = indent_of(line);
    const bool in_text = open_ == Open::paragraph || open_ == Open::item;
    if (in_comment_ || text.starts_with("<!--")) return take_comment(text);
    if (text.empty()) {
      if (open_ == Open::code) {
        pending_ += '\n';
      } else {
        end_block();
      }
    } else if (open_ == Open::table && is_row(line)) {
      if (!is_rule_of_table(line)) add_row(line, false);
    } else if (indent >= 4 && !in_text) {
      take_indented(line);
    } else if (const std::string_view fence = fence_of(line); !fence.empty()) {
      end_block();
      fence_ = fence;
      begin(MarkdownKind::code, Open::code);
    } else if (const int level = heading_level(line); level > 0) {
      end_block();
      begin(MarkdownKind::heading, Open::paragraph).level = level;
      text_ = trimmed(line.substr(static_cast<std::size_t>(level)));
      end_block();
    } else if (begins_table(line)) {
      end_block();
      add_row(line, true);
    } else if (const Marker marker = marker_of(text); !marker.shown.empty()) {
      end_block();
      MarkdownBlock& item = begin(MarkdownKind::item, Open::item);
      item.level = static_cast<int>(std::min<std::size_t>(indent / 2, 8));
      item.marker = marker.shown;
      text_ = text.substr(marker.size);
    } else {
      if (!in_text) {
        end_block();
        begin(MarkdownKind::paragraph, Open::paragraph);
      }
      if (!text_.empty()) text_ += ' ';
      text_ += text;
    }
  }

  void take_fenced(std::string_view line) {
    const std::string_view fence = fence_of(line);
    if (fence.size() < fence_.size() || fence.size() != trimmed(line).size()) {
      return add_code(line);
    }
    fence_.clear();
    end_block();
  }

  void take_indented(std::string_view line) {
    if (open_ != Open::code) {
      end_block();
      begin(MarkdownKind::code, Open::code);
    }
    add_code(line.substr(4));
  }

  void add_code(std::string_view line) {
    if (has_code_) text_ += '\n';
    text_ += std::exchange(pending_, {});
    text_ += line;
    has_code_ = true;
  }

  void take_comment(std::string_view text) { in_comment_ = text.find("-->") == kNone; }

  MarkdownBlock& begin(MarkdownKind kind, Open open) {
    blocks_.push_back({.kind = kind, .line = line_});
    open_ = open;
    return blocks_.back();
  }

  void add_row(std::string_view line, bool head) {
    MarkdownBlock& row = begin(MarkdownKind::row, Open::table);
    row.head = head;
    row.cells = cells_of(line);
  }

  // Ends the block that is being read, and reads the styles of its text.
  void end_block() {
    if (open_ == Open::code) {
      blocks_.back().cells = {{MarkdownSpan{.text = text_, .code = true}}};
    } else if (open_ == Open::paragraph || open_ == Open::item) {
      end_text(blocks_.back());
    }
    open_ = Open::nothing;
    text_.clear();
    pending_.clear();
    has_code_ = false;
  }

  // A paragraph that is one picture becomes a picture.
  void end_text(MarkdownBlock& block) {
    block.cells = {read_markdown_text(text_)};
    const bool picture = block.kind == MarkdownKind::paragraph && text_.starts_with("![");
    const std::size_t target = picture ? text_.find("](") : kNone;
    if (target == kNone || text_.find(')', target) != text_.size() - 1) return;
    block.kind = MarkdownKind::picture;
    block.picture = text_.substr(target + 2, text_.size() - target - 3);
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  Open open_ = Open::nothing;
  std::string fence_;    // of the code that is being read
  std::string text_;     // of the block that is being read
  std::string pending_;  // empty lines, which belong to the code if more of it follows
  bool has_code_ = false, in_comment_ = false;
  std::vector<MarkdownBlock> blocks_;
};

}  // namespace

MarkdownText read_markdown_text(std::string_view text) {
  return TextReader(text).read();
}

std::vector<MarkdownBlock> read_markdown(std::string_view text) {
  return BlockReader(text).read();
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
