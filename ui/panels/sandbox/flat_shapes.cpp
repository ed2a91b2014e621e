// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the shapes of the flat drawing with ImGui: discs, cells and lines.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/chart/flat_svg.hpp"
#include "ui/panels/sandbox/flat_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

ImU32 colour(const FlatColour& ink) {
  return IM_COL32(ink.r, ink.g, ink.b, static_cast<int>(std::lround(255 * ink.opacity)));
}

void dashed_line(ImDrawList* draw, ImVec2 a, ImVec2 b, ImU32 ink, float width, float dash) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const int dashes = std::min(2000, static_cast<int>(length / (2 * dash)) + 1);
  const ImVec2 step{(b.x - a.x) / length, (b.y - a.y) / length};
  for (int k = 0; k < dashes && length > 0; ++k) {
    const float from = 2 * dash * static_cast<float>(k), to = std::min(from + dash, length);
    if (from >= length) break;
    draw->AddLine({a.x + from * step.x, a.y + from * step.y},
                  {a.x + to * step.x, a.y + to * step.y}, ink, width);
  }
}

// Returns the number of sides of a polygon that replaces a circle and is nowhere farther than kOff
// from it.
int sides_of(float radius) {
  constexpr float kOff = 0.12f;  // pixels
  const double angle = std::acos(1 - kOff / std::max(radius, 1.0f));
  return std::clamp(static_cast<int>(std::ceil(M_PI / angle)), 12, 256);
}

// Fills a disc with horizontal slabs. ImGui's fans of thin triangles take several times as long in
// software OpenGL. The rim is not smooth, so the caller must draw a line over it.
void fill_disc(ImDrawList* draw, ImVec2 centre, float radius, ImU32 ink) {
  const int slabs = sides_of(radius) / 2;
  const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
  draw->PrimReserve(6 * slabs, 2 * (slabs + 1));
  const auto first = static_cast<ImDrawIdx>(draw->_VtxCurrentIdx);
  for (int k = 0; k <= slabs; ++k) {
    const double angle = M_PI * k / slabs;
    const float x = radius * static_cast<float>(std::sin(angle));
    const float y = centre.y - radius * static_cast<float>(std::cos(angle));
    draw->PrimWriteVtx({centre.x - x, y}, uv, ink);
    draw->PrimWriteVtx({centre.x + x, y}, uv, ink);
  }
  for (int k = 0; k < slabs; ++k) {
    for (const int corner : {0, 1, 2, 1, 3, 2}) {
      draw->PrimWriteIdx(static_cast<ImDrawIdx>(first + 2 * k + corner));
    }
  }
}

void draw_circle(ImDrawList* draw, const FlatStyle& style, ImVec2 centre, float radius,
                 float width) {
  constexpr float kHuge = 20000;  // pixels; a larger circle takes too many lines
  if (radius > kHuge) return;
  const bool rim = style.line.opacity > 0;
  const ImU32 fill = colour(style.fill);
  if (style.fill.opacity > 0 && rim) {
    fill_disc(draw, centre, radius, fill);
  } else if (style.fill.opacity > 0) {
    draw->AddCircleFilled(centre, radius, fill, sides_of(radius));
  }
  if (rim) draw->AddCircle(centre, radius, colour(style.line), sides_of(radius), width);
}

}  // namespace

void draw_flat_shape(PanelContext& ctx, const FlatPaper& paper, const FlatShape& shape) {
  const bool dark = ctx.state.theme() == Theme::dark;
  const FlatStyle style = flat_style(shape.kind, dark);
  const ImU32 fill = colour(style.fill), line = colour(style.line);
  // Lines of whole pixels take ImGui a third of the triangles.
  const float width = std::max(1.0f, std::round(ctx.px(static_cast<float>(style.line_width))));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  for (const FlatPoint& p : shape.points) points.push_back(paper.pixel(p));
  const int count = static_cast<int>(points.size());
  if (count == 1) {
    const float radius = style.dot_radius > 0 ? ctx.px(static_cast<float>(style.dot_radius))
                                              : paper.pixels(shape.radius);
    return draw_circle(draw, style, points[0], radius, width);
  }
  if (style.fill.opacity > 0 && count > 2) draw->AddConvexPolyFilled(points.data(), count, fill);
  if (style.line.opacity <= 0) return;
  for (int k = 0; k < (count == 2 ? 1 : count); ++k) {
    const ImVec2 a = points[static_cast<std::size_t>(k)],
                 b = points[static_cast<std::size_t>((k + 1) % count)];
    // Two cells share each side, in opposite directions, and only one of them draws it. A side of
    // one cell only is out of sight.
    if (shape.kind == FlatKind::cell && (a.x < b.x || (a.x == b.x && a.y < b.y))) continue;
    if (style.dashed) {
      dashed_line(draw, a, b, line, width, ctx.px(4));
    } else {
      draw->AddLine(a, b, line, width);
    }
  }
}

}  // namespace alphascope
