// SPDX-License-Identifier: GPL-3.0-or-later
// Draws plots with ImGui, and reads the mouse over them.
#include "ui/widgets/plot.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "ui/calls.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/rgb8.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

ImU32 colour_of(const PanelContext& ctx, const ChartPaint& paint) {
  const float opacity = paint.opacity * ImGui::GetStyle().Alpha;
  if (paint.colour) {
    const Rgb8& c = *paint.colour;
    return IM_COL32(c.r, c.g, c.b, static_cast<int>(std::lround(255 * opacity)));
  }
  const Palette& p = ctx.palette;
  const Colour& ink = paint.ink == ChartColourRole::text     ? p.text
                      : paint.ink == ChartColourRole::grid   ? p.border
                      : paint.ink == ChartColourRole::accent ? p.accent
                      : paint.ink == ChartColourRole::ground ? p.panel
                                                             : p.text_muted;
  return to_u32(ink, opacity);
}

void draw_dashed(ImDrawList* draw, ImVec2 from, ImVec2 to, ImU32 colour, float dash) {
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::max(1.0f, std::sqrt(dx * dx + dy * dy));
  const int dashes = static_cast<int>(std::ceil(length / (2 * dash)));
  for (int n = 0; n < dashes; ++n) {
    const float at = 2 * dash * static_cast<float>(n);
    const float end = std::min(at + dash, length);
    draw->AddLine({from.x + dx * at / length, from.y + dy * at / length},
                  {from.x + dx * end / length, from.y + dy * end / length}, colour, 1);
  }
}

class DrawingPainter {
 public:
  DrawingPainter(PanelContext& ctx, ImVec2 origin)
      : ctx_(ctx), draw_(ImGui::GetWindowDrawList()), origin_(origin) {}

  void add(const ChartLine& l) {
    const ImU32 colour = colour_of(ctx_, l.paint);
    if (l.dashed) return draw_dashed(draw_, at(l.x0, l.y0), at(l.x1, l.y1), colour, ctx_.px(4));
    draw_->AddLine(at(l.x0, l.y0), at(l.x1, l.y1), colour, l.width > 1 ? ctx_.px(l.width) : 1);
  }
  void add(const ChartBox& b) {
    const ImVec2 from = at(b.x, b.y), to = at(b.x + b.width, b.y + b.height);
    if (b.filled) {
      draw_->AddRectFilled(from, to, colour_of(ctx_, b.paint), b.rounding);
    } else {
      draw_->AddRect(from, to, colour_of(ctx_, b.paint), b.rounding);
    }
    note_tip(from, to, b.tip);
  }
  void add(const ChartPath& p) {
    points_.clear();
    for (const ChartPoint& point : p.points) points_.push_back(at(point.x, point.y));
    draw_->AddPolyline(points_.data(), static_cast<int>(points_.size()), colour_of(ctx_, p.paint),
                       0, p.width);
  }
  void add(const ChartDot& d) {
    const ImVec2 middle = at(d.x, d.y);
    const ImU32 colour = colour_of(ctx_, d.paint);
    if (d.ring) {
      draw_->AddCircleFilled(middle, d.radius, colour_of(ctx_, {ChartColourRole::ground, {}, 1}));
      draw_->AddCircle(middle, d.radius, colour, 0, ctx_.px(1.5f));
    } else {
      draw_->AddCircleFilled(middle, d.radius, colour);
    }
    note_tip({middle.x - d.radius, middle.y - d.radius}, {middle.x + d.radius, middle.y + d.radius},
             d.tip);
  }
  void add(const ChartText& t) {
    if (t.title) ImGui::PushFont(ctx_.fonts.strong);
    const float width = ImGui::CalcTextSize(t.text.c_str()).x;
    const float shift = t.anchor == ChartAnchor::start    ? 0
                        : t.anchor == ChartAnchor::middle ? width / 2
                                                          : width;
    draw_->AddText(at(t.x - shift, t.y - ImGui::GetFontSize() / 2), colour_of(ctx_, {t.ink, {}, 1}),
                   t.text.c_str());
    if (t.title) ImGui::PopFont();
  }
  const std::string& tip() const { return tip_; }

 private:
  ImVec2 at(float x, float y) const { return {origin_.x + x, origin_.y + y}; }
  void note_tip(ImVec2 from, ImVec2 to, const std::string& tip) {
    if (!tip.empty() && ImGui::IsMouseHoveringRect(from, to)) tip_ = tip;
  }

  PanelContext& ctx_;
  ImDrawList* draw_;
  ImVec2 origin_;
  std::vector<ImVec2> points_;
  std::string tip_;
};

}  // namespace

ChartPaint plot_colour(const Rgb8& c, float opacity) {
  return {ChartColourRole::text, c, opacity};
}

ChartPaint plot_colour(const Colour& colour, float opacity) {
  return plot_colour(to_rgb8(colour), opacity * colour.a);
}

ChartFont chart_type(const PanelContext& ctx) {
  return {ImGui::GetFontSize(),
          [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }, ctx.px(1)};
}

std::string draw_drawing(PanelContext& ctx, const ChartDrawing& drawing, ImVec2 origin) {
  DrawingPainter painter(ctx, origin);
  for (const ChartLine& line : drawing.lines) painter.add(line);
  for (const ChartBox& box : drawing.boxes) painter.add(box);
  for (const ChartPath& path : drawing.paths) painter.add(path);
  for (const ChartDot& dot : drawing.dots) painter.add(dot);
  for (const ChartText& text : drawing.texts) painter.add(text);
  return painter.tip();
}

std::optional<PlotArea> plot_area(const PanelContext& ctx, const PlotMargins& m) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float line = ImGui::GetTextLineHeight();
  PlotArea area;
  area.left = corner.x + ctx.px(m.left);
  area.top = corner.y + ctx.px(m.top) + m.lines_above * line;
  area.right = corner.x + room.x - ctx.px(m.right);
  area.bottom = corner.y + room.y - ctx.px(m.bottom) - m.lines_below * line;
  const bool fits =
      area.width() >= ctx.px(m.least_width) && area.height() >= ctx.px(m.least_height);
  return fits ? std::optional(area) : std::nullopt;
}

void draw_plot(PanelContext& ctx, const Plot& plot, PlotArea& area) {
  area.x = plot.x.range;
  area.y = plot.y.range;
  draw_drawing(ctx, lay_out(plot, area, chart_type(ctx)), {0, 0});
}

PlotMouse plot_mouse(PanelContext& ctx, const PlotArea& area, const char* name) {
  constexpr float kDrag = 4;  // pixels at scale 1; a shorter move is a click
  ImGui::SetCursorScreenPos({area.left, area.top});
  ImGui::InvisibleButton((std::string("##") + name).c_str(), {area.width(), area.height()});
  record(ctx, name);
  const ImGuiIO& io = ImGui::GetIO();
  PlotMouse mouse;
  mouse.hovered = ImGui::IsItemHovered();
  mouse.held = ImGui::IsItemActive();
  mouse.dragged = io.MouseDragMaxDistanceSqr[0] > ctx.px(kDrag) * ctx.px(kDrag);
  mouse.clicked = ImGui::IsItemDeactivated() && mouse.hovered && !mouse.dragged;
  mouse.x = area.x_at(std::clamp(io.MousePos.x, area.left, area.right));
  mouse.y = area.y_at(std::clamp(io.MousePos.y, area.top, area.bottom));
  return mouse;
}

void draw_cursor(PanelContext& ctx, const Plot& plot, const PlotArea& area, double x) {
  ChartDrawing drawing;
  drawing.lines.push_back(
      {area.x_of(x), area.top, area.x_of(x), area.bottom, plot_ink(ChartColourRole::muted, 0.7f)});
  for (const PlotCurve& curve : plot.curves) {
    const auto n = nearest_point(curve, x);
    if (!n || !curve.points[*n].y) continue;
    drawing.dots.push_back({area.x_of(curve.points[*n].x),
                            area.y_of(*curve.points[*n].y),
                            curve.paint,
                            {},
                            ctx.px(3)});
  }
  draw_drawing(ctx, drawing, {0, 0});
}

void legend_entry(PanelContext& ctx, const Rgb8& colour, const std::string& name) {
  ImGui::SameLine(0, ctx.px(14));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side = ctx.px(9), middle = corner.y + ImGui::GetFrameHeight() / 2;
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, middle - side / 2},
                                            {corner.x + side, middle + side / 2},
                                            colour_of(ctx, plot_colour(colour)));
  ImGui::SetCursorScreenPos({corner.x + side + ctx.px(5), corner.y});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name.c_str());
}

}  // namespace alphascope
