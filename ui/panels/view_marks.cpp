// See the header. Also the words at places of the picture.
#include "ui/panels/view_marks.hpp"

#include <algorithm>
#include <cmath>

#include "ui/panels/clip_panel.hpp"
#include "ui/panels/flat_view.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sandbox_edit.hpp"

namespace alphascope {
namespace {

ImVec2 at(ImVec2 corner, float x, float y) {
  return {corner.x + x, corner.y + y};
}

void mark_text(ImVec2 corner, const MarkText& text, ImU32 ink) {
  ImGui::GetWindowDrawList()->AddText(at(corner, text.x, text.y), ink, text.text.c_str());
}

MarkType mark_type(const PanelContext& ctx) {
  return {ctx.scale, ImGui::GetTextLineHeight(),
          [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }};
}

void scale_bar(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const ViewState& s = ctx.state;
  const double angstrom_per_pixel =
      shows_flat_drawing(s) ? flat_angstrom_per_pixel(s) : s.viewport.angstrom_per_pixel;
  const auto layout = lay_out_scale_bar(angstrom_per_pixel, size.x, size.y, mark_type(ctx));
  if (!layout) return;
  const ImU32 ink = to_u32(ctx.palette.text_muted);
  for (const MarkBox& line : layout->lines) {
    ImGui::GetWindowDrawList()->AddRectFilled(at(corner, line.x0, line.y0),
                                              at(corner, line.x1, line.y1), ink);
  }
  mark_text(corner, layout->text, ink);
}

void colour_bar(const std::vector<ColourLegend::Stop>& stops, const MarkBox& bar, ImVec2 corner) {
  const float step = (bar.x1 - bar.x0) / static_cast<float>(stops.size() - 1);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const float x = bar.x0 + step * static_cast<float>(i);
    const ImU32 left = to_u32(stops[i].colour), right = to_u32(stops[i + 1].colour);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor(
        at(corner, x, bar.y0), at(corner, x + step, bar.y1), left, right, right, left);
  }
}

void legend(PanelContext& ctx, const ColourLegend& legend, const LegendLayout& layout,
            ImVec2 corner) {
  const ImU32 ink = to_u32(ctx.palette.text_muted);
  const auto fill = [&](const MarkBox& box, ImU32 colour) {
    ImGui::GetWindowDrawList()->AddRectFilled(at(corner, box.x0, box.y0),
                                              at(corner, box.x1, box.y1), colour);
  };
  if (layout.bar) colour_bar(legend.stops, *layout.bar, corner);
  for (const MarkBox& tick : layout.ticks) fill(tick, ink);
  for (const LegendLayout::Patch& patch : layout.patches) fill(patch.box, to_u32(patch.colour));
  for (const MarkText& text : layout.texts) mark_text(corner, text, ink);
}

// Returns how high they are, in pixels from the bottom.
float legends(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const auto& all = ctx.state.viewport.legends;
  const auto layouts = lay_out_legends(all, size.x, size.y, mark_type(ctx));
  if (layouts.empty()) return 0;
  // Those that have no room are the first ones.
  const std::size_t skipped = all.size() - layouts.size();
  WidgetRect whole{size.x, size.y, 0, 0, true};
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    legend(ctx, all[skipped + i], layouts[i], corner);
    const MarkBox& box = layouts[i].whole;
    whole = {std::min(whole.x0, box.x0), std::min(whole.y0, box.y0), std::max(whole.x1, box.x1),
             std::max(whole.y1, box.y1), true};
  }
  ctx.rects["view.legend"] = {corner.x + whole.x0, corner.y + whole.y0, corner.x + whole.x1,
                              corner.y + whole.y1, true};
  return size.y - whole.y0;
}

}  // namespace

float draw_view_marks(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  scale_bar(ctx, corner, size);
  return shows_flat_drawing(ctx.state) ? 0 : legends(ctx, corner, size);
}

void draw_view_labels(PanelContext& ctx) {
  if (shows_flat_drawing(ctx.state)) return;
  draw_clip_handle(ctx);
  const ViewportInfo& v = ctx.state.viewport;
  if (v.labels.empty() || v.texture == 0 || !ctx.state.molecule.loaded) return;
  const ImVec2 corner = ImGui::GetWindowPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 rim = to_u32(ctx.palette.scene), ink = to_u32(ctx.palette.text);
  const float reach = kMarkOutline * ctx.scale;
  constexpr int kAround = 12;
  for (const MarkText& text : lay_out_labels(v.labels, static_cast<float>(v.width),
                                             static_cast<float>(v.height), mark_type(ctx))) {
    for (int k = 0; k < kAround; ++k) {
      const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(k) / kAround;
      const ImVec2 place =
          at(corner, text.x + reach * std::cos(angle), text.y + reach * std::sin(angle));
      draw->AddText(place, rim, text.text.c_str());
    }
    mark_text(corner, text, ink);
  }
}

}  // namespace alphascope
