// SPDX-License-Identifier: GPL-3.0-or-later
// Places text word by word. A word may consist of parts in several fonts.
#include "ui/widgets/flowing_text.hpp"

#include <algorithm>
#include <cfloat>
#include <utility>
#include <vector>

#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

float width_of(const FlowSpan& span, std::string_view text) {
  const char* const begin = text.data();
  const float size = span.font->FontSize * span.size;
  return span.font->CalcTextSizeA(size, FLT_MAX, 0, begin, begin + text.size()).x;
}

struct Part {
  std::size_t span = 0;
  std::string_view text;
  float width = 0;
  float before = 0, behind = 0;  // padding of the span

  float whole() const { return before + width + behind; }
};

// Calls word(parts) for each word, blank(width, span) for blanks between words, and end_line() for
// line ends.
template <class Word, class Blank, class EndLine>
void for_each_word(std::span<const FlowSpan> spans, const Word& word, const Blank& blank,
                   const EndLine& end_line) {
  std::vector<Part> parts;
  const auto end_word = [&] {
    if (!parts.empty()) word(parts);
    parts.clear();
  };
  for (std::size_t n = 0; n < spans.size(); ++n) {
    std::string_view rest = spans[n].text;
    while (!rest.empty()) {
      const char first = rest.front();
      if (first == ' ' || first == '\n') {
        end_word();
        if (first == ' ') blank(width_of(spans[n], " "), n);
        if (first == '\n') end_line();
        rest.remove_prefix(1);
        continue;
      }
      std::size_t end = rest.find_first_of(" \n");
      while (end != rest.npos && rest.substr(end).starts_with(" Å")) {
        end = rest.find_first_of(" \n", end + 1);
      }
      const std::string_view text = rest.substr(0, end);
      const bool first_part = rest.size() == spans[n].text.size(),
                 last = text.size() == rest.size();
      parts.push_back({n, text, width_of(spans[n], text), first_part ? spans[n].padding : 0,
                       last ? spans[n].padding : 0});
      rest.remove_prefix(text.size());
    }
  }
  end_word();
}

class Flow {
 public:
  Flow(std::span<const FlowSpan> spans, const FlowArea& area,
       const std::function<void(const FlowPiece&)>& use)
      : spans_(spans), area_(area), use_(use), x_(area.corner.x), y_(area.corner.y) {}

  void put(std::vector<Part>& parts) {
    float width = 0;
    for (const Part& part : parts) width += part.whole();
    if (!at_left() && x_ + blank_ + width > right()) end_line();
    if (!at_left()) x_ += blank_;
    for (Part& part : parts) {
      while (part.whole() > right() - x_ && break_part(part)) {
      }
      emit(part);
    }
    blank_ = 0;
  }
  void blank(float width, std::size_t span) {
    blank_ = std::max(blank_, width);
    blank_span_ = span;
  }
  void end_line() {
    x_ = area_.corner.x;
    y_ += area_.line;
    blank_ = 0;
    last_span_ = kNone;
  }
  float height() const { return y_ + area_.line - area_.corner.y; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  bool at_left() const { return x_ <= area_.corner.x; }
  float right() const { return area_.corner.x + area_.width; }

  // Places as many letters of the part as fit into the line, at least one at its begin. Returns
  // whether letters are left.
  bool break_part(Part& part) {
    const FlowSpan& span = spans_[part.span];
    const char *const begin = part.text.data(), *const end = begin + part.text.size();
    const char* rest = begin;
    const float room = std::max(0.0f, right() - x_ - part.before);
    span.font->CalcTextSizeA(span.font->FontSize * span.size, room, 0, begin, end, &rest);
    if (rest == begin && at_left()) {
      ++rest;
      while (rest < end && continues_character(*rest)) ++rest;
    }
    if (rest == end) return false;
    // Paths and lists of choices are broken behind their marks.
    for (const char* mark = rest; mark > begin; --mark) {
      if (mark[-1] != '|' && mark[-1] != '/') continue;
      rest = mark;
      break;
    }
    const std::string_view fits(begin, static_cast<std::size_t>(rest - begin));
    if (!fits.empty()) emit({part.span, fits, width_of(span, fits), part.before, 0});
    if (!fits.empty()) part.before = 0;
    part.text.remove_prefix(fits.size());
    part.width = width_of(span, part.text);
    end_line();
    return true;
  }

  void emit(const Part& part) {
    const float gap = part.span == last_span_ && part.span == blank_span_ ? blank_ : 0;
    if (use_) {
      const float below = (area_.line - area_.base->FontSize) / 2 + area_.base->Ascent;
      const float left = x_ + part.before;
      use_({part.span,
            part.text,
            {left, y_},
            {left + part.width, y_ + area_.line},
            y_ + below,
            gap});
    }
    x_ += part.whole();
    last_span_ = part.span;
    blank_ = 0;
  }

  std::span<const FlowSpan> spans_;
  const FlowArea& area_;
  const std::function<void(const FlowPiece&)>& use_;
  float x_, y_;
  float blank_ = 0;  // before the next word
  std::size_t blank_span_ = kNone, last_span_ = kNone;
};

}  // namespace

float flow_text(std::span<const FlowSpan> spans, const FlowArea& area,
                const std::function<void(const FlowPiece&)>& use) {
  Flow flow(spans, area, use);
  for_each_word(
      spans, [&](std::vector<Part>& parts) { flow.put(parts); },
      [&](float width, std::size_t span) { flow.blank(width, span); }, [&] { flow.end_line(); });
  return flow.height();
}

FlowWidths flow_widths(std::span<const FlowSpan> spans) {
  FlowWidths widths;
  float line = 0, gap = 0;
  const auto word = [&](const std::vector<Part>& parts) {
    float width = 0;
    for (const Part& part : parts) width += part.whole();
    widths.least = std::max(widths.least, width);
    line += std::exchange(gap, 0.0f) + width;
    widths.natural = std::max(widths.natural, line);
  };
  for_each_word(
      spans, word, [&](float width, std::size_t) { gap = line > 0 ? width : 0; },
      [&] { line = gap = 0; });
  return widths;
}

}  // namespace alphascope
