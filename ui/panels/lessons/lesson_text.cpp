// SPDX-License-Identifier: GPL-3.0-or-later
// Draws and measures paragraphs in two fonts.
#include "ui/panels/lessons/lesson_text.hpp"

#include <string>
#include <vector>

#include "core/document/lessons/lesson.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/flowing_text.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

struct Way {  // factor on the letters' size; whether text is drawn or only measured
  float size = 1;
  bool draws = true;
};

// Draws or measures the nth paragraph at `corner`. Returns its height with the gap below.
float put_paragraph(PanelContext& ctx, const std::vector<LessonParagraph>& text, std::size_t n,
                    ImVec2 corner, float width, Way way) {
  const LessonParagraph& paragraph = text[n];
  const float indent = paragraph.item ? ctx.px(14) : 0, gap_of_lines = ctx.px(4) * way.size;
  if (paragraph.item && way.draws) {
    ImGui::GetWindowDrawList()->AddText(corner, to_u32(ctx.palette.text_muted), "•");
  }
  const std::vector<LessonSpan> text_spans = lesson_spans(paragraph.text);
  std::vector<FlowSpan> spans;
  for (const LessonSpan& span : text_spans) {
    spans.push_back({span.text, span.bold ? ctx.fonts.strong : ctx.fonts.regular, way.size});
  }
  const float line = ImGui::GetTextLineHeight() * way.size + gap_of_lines;
  const FlowArea area{{corner.x + indent, corner.y}, width - indent, line, ctx.fonts.regular};
  const auto draw = [&](const FlowPiece& piece) {
    const ImFont& font = *spans[piece.span].font;
    const char* const begin = piece.text.data();
    ImGui::GetWindowDrawList()->AddText(&font, font.FontSize * way.size, piece.low,
                                        to_u32(ctx.palette.text), begin, begin + piece.text.size());
  };
  const float height = way.draws ? flow_text(spans, area, draw) : flow_text(spans, area);
  const bool list_goes_on = paragraph.item && n + 1 < text.size() && text[n + 1].item;
  const float gap = ctx.px(list_goes_on ? 2 : 7) * way.size;
  return height + gap;
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
