// SPDX-License-Identifier: GPL-3.0-or-later
// Draws blocks of the guide. guide_page.cpp puts them one below the other.
#include "ui/panels/guide/guide_text.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <tuple>

#include "core/document/guide/guide.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/flowing_text.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Sizes in pixels at scale 1.
constexpr float kLineGap = 4, kCellPadding = 7, kCodePadding = 8, kItemIndent = 16;
constexpr float kCodeMargin = 2;         // around words of code
constexpr float kSecondHeading = 0.75f;  // factor on the large font

struct TextStyle {
  ImFont* font = nullptr;  // of words without a style of their own
  float size = 1;
  const Colour* colour = nullptr;
};

std::vector<FlowSpan> flow_spans(const PanelContext& ctx, const MarkdownText& text,
                                 const TextStyle& style) {
  std::vector<FlowSpan> spans;
  for (const MarkdownSpan& span : text) {
    const bool strong = span.strong && style.font == ctx.fonts.regular;
    const bool mono = span.code && style.size >= 1 && style.font != ctx.fonts.large;
    ImFont* const font = mono ? ctx.fonts.mono : strong ? ctx.fonts.strong : style.font;
    spans.push_back({span.text, font, style.size, span.code ? ctx.px(kCodeMargin) : 0});
  }
  return spans;
}

// Leans the letters that were drawn since the vertex `first`: the program has no italic font.
void slant(ImDrawList& draw, int first, float baseline) {
  constexpr float kSlant = 0.2f;
  for (int n = first; n < draw.VtxBuffer.Size; ++n) {
    ImVec2& place = draw.VtxBuffer[n].pos;
    place.x += (baseline - place.y) * kSlant;
  }
}

// Marks the wanted words of a piece.
void mark_words(const PanelContext& ctx, const FlowSpan& span, const FlowPiece& piece,
                const std::vector<std::string>& words) {
  const auto width = [&](std::string_view text) {
    const float size = span.font->FontSize * span.size;
    return span.font->CalcTextSizeA(size, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
  };
  std::size_t from = 0;
  for (auto [at, length] = find_word(piece.text, words, 0); length > 0;
       std::tie(at, length) = find_word(piece.text, words, from)) {
    const float left = piece.low.x + width(piece.text.substr(0, at));
    const float right = left + width(piece.text.substr(at, length));
    ImGui::GetWindowDrawList()->AddRectFilled({left - 1, piece.low.y + 1},
                                              {right + 1, piece.high.y - 1},
                                              to_u32(ctx.palette.accent, 0.40f), ctx.px(2));
    from = at + length;
  }
}

void draw_piece(PanelContext& ctx, const MarkdownSpan& source, const FlowSpan& span,
                const FlowPiece& piece, const TextStyle& style, const GuideLook& look) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (source.code) {
    const float out = ctx.px(kCodeMargin);
    draw.AddRectFilled({piece.low.x - std::max(out, piece.gap), piece.low.y + ctx.px(1)},
                       {piece.high.x + out, piece.high.y - ctx.px(1)}, to_u32(ctx.palette.field),
                       piece.gap > 0 ? 0 : ctx.px(3));
  }
  if (look.words != nullptr) mark_words(ctx, span, piece, *look.words);
  const bool link = !source.link.empty();
  const ImU32 colour = to_u32(link ? ctx.palette.accent : *style.colour);
  const int first = draw.VtxBuffer.Size;
  const float size = span.font->FontSize * span.size;
  draw.AddText(span.font, size, {piece.low.x, piece.baseline - span.font->Ascent * span.size},
               colour, piece.text.data(), piece.text.data() + piece.text.size());
  if (source.emphasis && !source.code) slant(draw, first, piece.baseline);
  if (!link) return;
  const float under = piece.baseline + ctx.px(2);
  draw.AddLine({piece.low.x - piece.gap, under}, {piece.high.x, under},
               to_u32(ctx.palette.accent, 0.5f), 1);
}

float line_height(const PanelContext& ctx, const TextStyle& style) {
  return style.font->FontSize * style.size + ctx.px(kLineGap);
}

// Draws or measures one text, and returns its height.
float put_text(PanelContext& ctx, const MarkdownText& text, ImVec2 corner, float width,
               const TextStyle& style, const GuideLook& look) {
  const std::vector<FlowSpan> spans = flow_spans(ctx, text, style);
  const FlowArea area{corner, width, line_height(ctx, style), style.font};
  if (!look.draws) return flow_text(spans, area);
  return flow_text(spans, area, [&](const FlowPiece& piece) {
    const MarkdownSpan& source = text[piece.span];
    draw_piece(ctx, source, spans[piece.span], piece, style, look);
    if (source.link.empty() || look.links == nullptr) return;
    look.links->push_back({source.link, piece.low, piece.high});
  });
}

float put_heading(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
                  const GuideLook& look) {
  const bool large = block.level <= 2;
  TextStyle style{large ? ctx.fonts.large : ctx.fonts.strong, 1, &ctx.palette.text};
  if (block.level == 2) style.size = kSecondHeading;
  const float above = ctx.px(block.level == 1 ? 2 : block.level == 2 ? 14 : 8);
  const float height =
      put_text(ctx, block.cells.at(0), {corner.x, corner.y + above}, width, style, look);
  const float below = above + height + ctx.px(2);
  if (block.level > 2) return below + ctx.px(2);
  if (look.draws) {
    const float y = corner.y + below;
    ImGui::GetWindowDrawList()->AddLine({corner.x, y}, {corner.x + width, y},
                                        to_u32(ctx.palette.border), 1);
  }
  return below + ctx.px(8);
}

float put_item(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
               const TextStyle& style, const GuideLook& look) {
  const float number = block.marker == "•" ? 0 : ctx.px(6);
  const float left = ctx.px(kItemIndent) * static_cast<float>(block.level);
  const float indent = left + ctx.px(kItemIndent) + number;
  if (look.draws) {
    const float top = corner.y + (line_height(ctx, style) - style.font->FontSize) / 2;
    ImGui::GetWindowDrawList()->AddText({corner.x + left + ctx.px(3), top},
                                        to_u32(ctx.palette.text_muted), block.marker.c_str());
  }
  return ctx.px(3) + put_text(ctx, block.cells.at(0), {corner.x + indent, corner.y}, width - indent,
                              style, look);
}

// Code keeps its blanks and lines. A line that is too long goes on below.
float put_code(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
               const GuideLook& look) {
  const ImFont& font = *ctx.fonts.mono;
  const float padding = ctx.px(kCodePadding), line = font.FontSize + ctx.px(kLineGap);
  const float room = std::max(ctx.px(40), width - 2 * padding - ctx.px(kCopyButtonWidth));
  const std::string& code = block.cells.at(0).at(0).text;
  std::vector<std::string_view> lines;
  for (const char *at = code.data(), *const end = at + code.size(); at <= end;) {
    const char* const line_end = std::find(at, end, '\n');
    const char* rest = at;
    font.CalcTextSizeA(font.FontSize, room, 0, at, line_end, &rest);
    if (rest == at && at < line_end) rest = line_end;
    lines.emplace_back(at, static_cast<std::size_t>(rest - at));
    at = rest == line_end ? rest + 1 : rest;
  }
  const float height = static_cast<float>(lines.size()) * line + 2 * padding;
  if (look.draws) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, to_u32(ctx.palette.field),
                       ctx.px(4));
    ImVec2 at{corner.x + padding, corner.y + padding};
    for (const std::string_view text : lines) {
      const FlowSpan span{text, &font, 1};
      const ImVec2 high{corner.x + width, at.y + line};
      const FlowPiece piece{0, text, at, high, at.y + font.Ascent, 0};
      if (look.words != nullptr) mark_words(ctx, span, piece, *look.words);
      draw.AddText(&font, font.FontSize, {at.x, at.y + ctx.px(kLineGap) / 2},
                   to_u32(ctx.palette.text), text.data(), text.data() + text.size());
      at.y += line;
    }
  }
  return height + ctx.px(10);
}

TextStyle cell_style(const PanelContext& ctx, const MarkdownBlock& row) {
  return {row.head ? ctx.fonts.strong : ctx.fonts.regular, 1,
          row.head ? &ctx.palette.text_muted : &ctx.palette.text};
}

float put_row(PanelContext& ctx, const MarkdownBlock& row, ImVec2 corner,
              const std::vector<float>& columns, const GuideLook& look) {
  const TextStyle style = cell_style(ctx, row);
  const float padding = ctx.px(kCellPadding), above = ctx.px(3);
  float x = corner.x, height = line_height(ctx, style);
  for (std::size_t n = 0; n < std::min(columns.size(), row.cells.size()); ++n) {
    const float room = std::max(ctx.px(10), columns[n] - 2 * padding);
    height = std::max(
        height, put_text(ctx, row.cells[n], {x + padding, corner.y + above}, room, style, look));
    x += columns[n];
  }
  height += 2 * above;
  if (look.draws) {
    const float y = corner.y + height, wide = std::accumulate(columns.begin(), columns.end(), 0.0f);
    ImGui::GetWindowDrawList()->AddLine({corner.x, y}, {corner.x + wide, y},
                                        to_u32(ctx.palette.border), row.head ? ctx.px(1.5f) : 1);
  }
  return height + 1;
}

float put_picture(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
                  const GuideLook& look) {
  MarkdownText text{{.text = "Picture: ", .strong = true}};
  text.insert(text.end(), block.cells.at(0).begin(), block.cells.at(0).end());
  const TextStyle style{ctx.fonts.regular, 1, &ctx.palette.text_muted};
  const float padding = ctx.px(kCodePadding);
  const float height = 2 * padding + put_text(ctx, text, {corner.x + padding, corner.y + padding},
                                              width - 2 * padding, style, look);
  if (look.draws) {
    ImGui::GetWindowDrawList()->AddRect(corner, {corner.x + width, corner.y + height},
                                        to_u32(ctx.palette.border), ctx.px(4));
  }
  return height + ctx.px(10);
}

}  // namespace

float put_guide_block(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
                      const std::vector<float>& columns, const GuideLook& look) {
  const TextStyle style{ctx.fonts.regular, 1, &ctx.palette.text};
  switch (block.kind) {
    case MarkdownKind::heading:
      return put_heading(ctx, block, corner, width, look);
    case MarkdownKind::item:
      return put_item(ctx, block, corner, width, style, look);
    case MarkdownKind::code:
      return put_code(ctx, block, corner, width, look);
    case MarkdownKind::row:
      return put_row(ctx, block, corner, columns, look);
    case MarkdownKind::picture:
      return put_picture(ctx, block, corner, width, look);
    case MarkdownKind::paragraph:
      break;
  }
  return put_text(ctx, block.cells.at(0), corner, width, style, look) + ctx.px(8);
}

std::vector<float> guide_columns(PanelContext& ctx, const std::vector<MarkdownBlock>& blocks,
                                 std::size_t begin, std::size_t end, float width) {
  constexpr float kWidestWord = 0.35f;  // share of the width that a word may demand
  std::vector<FlowWidths> wanted;
  for (std::size_t n = begin; n < end; ++n) {
    const MarkdownBlock& row = blocks[n];
    if (wanted.size() < row.cells.size()) wanted.resize(row.cells.size());
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const auto widths = flow_widths(flow_spans(ctx, row.cells[c], cell_style(ctx, row)));
      wanted[c].natural = std::max(wanted[c].natural, widths.natural);
      wanted[c].least = std::max(wanted[c].least, std::min(widths.least, kWidestWord * width));
    }
  }
  const float padding = 2 * ctx.px(kCellPadding) + 1;
  const auto widths_up_to = [&](float limit) {
    std::vector<float> columns;
    for (const FlowWidths& w : wanted) {
      columns.push_back(std::min(w.natural, std::max(w.least, limit)) + padding);
    }
    return columns;
  };
  const auto sum = [](const std::vector<float>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0f);
  };
  // Narrow columns are as wide as their text. Wide ones are all as wide as a limit allows, which is
  // found by halving an interval, but no narrower than their widest words.
  float low = 0, high = width;
  while (high - low > 0.5f) {
    const float middle = (low + high) / 2;
    (sum(widths_up_to(middle)) <= width ? low : high) = middle;
  }
  std::vector<float> columns = widths_up_to(low);
  const float shrink = std::min(1.0f, width / std::max(1.0f, sum(columns)));
  for (float& column : columns) column *= shrink;
  return columns;
}

}  // namespace alphascope
