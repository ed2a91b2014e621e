// SPDX-License-Identifier: GPL-3.0-or-later
// Draws and measures text of several fonts. ImGui wraps text of one font only, so each word is
// placed by itself.
#include "ui/panels/lessons/lesson_text.hpp"

#include <string>
#include <string_view>

#include "core/document/lessons/lesson.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// The place of the next word, in pixels of the screen.
struct Pen {
  ImVec2 at;
  float left = 0, right = 0, line = 0, size = 1;
  bool draws = true;
};

void put_word(const PanelContext& ctx, Pen& pen, std::string_view word, bool bold) {
  ImFont* const font = bold ? ctx.fonts.strong : ctx.fonts.regular;
  const char *begin = word.data(), *end = begin + word.size();
  const float size = font->FontSize * pen.size;
  const float width = font->CalcTextSizeA(size, FLT_MAX, 0, begin, end).x;
  if (pen.at.x + width > pen.right && pen.at.x > pen.left) pen.at = {pen.left, pen.at.y + pen.line};
  if (pen.draws) {
    ImGui::GetWindowDrawList()->AddText(font, size, pen.at, to_u32(ctx.palette.text), begin, end);
  }
  pen.at.x += width;
}

// Draws a span word by word. Blanks are in the span, so a word may go on in another font.
void put_span(const PanelContext& ctx, Pen& pen, const LessonSpan& span) {
  std::string_view rest = span.text;
  const float blank = ImGui::CalcTextSize(" ").x * pen.size;
  while (!rest.empty()) {
    if (rest.front() == ' ') {
      if (pen.at.x > pen.left) pen.at.x += blank;
      rest.remove_prefix(1);
      continue;
    }
    std::size_t end = rest.find(' ');
    while (end != rest.npos && rest.substr(end + 1).starts_with("Å")) {  // a number keeps its unit
      end = rest.find(' ', end + 1);
    }
    const std::string_view word = rest.substr(0, end);
    put_word(ctx, pen, word, span.bold);
    rest.remove_prefix(word.size());
  }
}

struct Way {  // factor on the letters' size; whether text is drawn or only measured
  float size = 1;
  bool draws = true;
};

// Draws or measures the nth paragraph at `corner`. Returns its height with the gap below.
float put_paragraph(PanelContext& ctx, const std::vector<LessonParagraph>& text, std::size_t n,
                    ImVec2 corner, float width, Way way) {
  const LessonParagraph& paragraph = text[n];
  const float indent = paragraph.item ? ctx.px(14) : 0;
  Pen pen;
  pen.size = way.size;
  pen.draws = way.draws;
  pen.left = corner.x + indent;
  pen.right = corner.x + width;
  pen.line = (ImGui::GetTextLineHeight() + ctx.px(4)) * way.size;
  pen.at = {pen.left, corner.y};
  if (paragraph.item && way.draws) {
    ImGui::GetWindowDrawList()->AddText(corner, to_u32(ctx.palette.text_muted), "•");
  }
  for (const LessonSpan& span : lesson_spans(paragraph.text)) put_span(ctx, pen, span);
  const bool list_goes_on = paragraph.item && n + 1 < text.size() && text[n + 1].item;
  const float gap = ctx.px(list_goes_on ? 2 : 7) * way.size;
  return pen.at.y + pen.line + gap - corner.y;
}

}  // namespace

void draw_lesson_text(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  const float width = ImGui::GetContentRegionAvail().x;
  for (std::size_t n = 0; n < text.size(); ++n) {
    ImGui::Dummy(
        {width, put_paragraph(ctx, text, n, ImGui::GetCursorScreenPos(), width, {size, true})});
  }
  ImGui::PopStyleVar();
}

float lesson_text_height(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size,
                         float width) {
  float height = 0;
  for (std::size_t n = 0; n < text.size(); ++n) {
    height += put_paragraph(ctx, text, n, {0, 0}, width, {size, false});
  }
  return height;
}

}  // namespace alphascope
