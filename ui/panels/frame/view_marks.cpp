// SPDX-License-Identifier: GPL-3.0-or-later
// Draws scale bar, legends and labels over the view, with ImGui.
#include "ui/panels/frame/view_marks.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "ui/colour_legend.hpp"
#include "ui/panels/complex/clip_panel.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sandbox/flat_view.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/picture_marks.hpp"

namespace alphascope {
namespace {

ImVec2 at(ImVec2 corner, float x, float y) {
  return {corner.x + x, corner.y + y};
}

void mark_text(const PanelContext& ctx, ImVec2 corner, const MarkText& text, ImU32 ink) {
  const ImVec2 place = at(corner, text.x, text.y);
  draw_rim(ctx, place, text.text);
  ImGui::GetWindowDrawList()->AddText(place, ink, text.text.c_str());
}

void fill(ImVec2 corner, const MarkBox& box, ImU32 colour, float rim = 0) {
  ImGui::GetWindowDrawList()->AddRectFilled(at(corner, box.x0 - rim, box.y0 - rim),
                                            at(corner, box.x1 + rim, box.y1 + rim), colour);
}

MarkFont mark_type(const PanelContext& ctx) {
  return {ctx.scale, ImGui::GetTextLineHeight(),
          [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }};
}

void scale_bar(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const ViewState& s = ctx.state;
  const double angstrom_per_pixel =
      shows_flat_drawing(s) ? flat_angstrom_per_pixel(s) : s.viewport.angstrom_per_pixel;
  const auto layout = lay_out_scale_bar(angstrom_per_pixel, size.x, size.y, mark_type(ctx));
  if (!layout) return;
  const ImU32 ink = to_u32(ctx.palette.text_muted), behind = to_u32(ctx.palette.scene);
  for (const MarkBox& line : layout->lines) fill(corner, line, behind, kMarkOutline * ctx.scale);
  for (const MarkBox& line : layout->lines) fill(corner, line, ink);
  mark_text(ctx, corner, layout->text, ink);
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
  const ImU32 ink = to_u32(ctx.palette.text_muted), behind = to_u32(ctx.palette.scene);
  const float rim = kMarkOutline * ctx.scale;
  if (layout.bar) {
    fill(corner, *layout.bar, behind, rim);
    colour_bar(legend.stops, *layout.bar, corner);
  }
  for (const MarkBox& tick : layout.ticks) {
    fill(corner, tick, behind, rim);
    fill(corner, tick, ink);
  }
  for (const LegendLayout::Patch& patch : layout.patches) {
    fill(corner, patch.box, behind, rim);
    fill(corner, patch.box, to_u32(patch.colour));
  }
  for (const MarkText& text : layout.texts) mark_text(ctx, corner, text, ink);
}

// Draws the legends. Returns their height above the view's bottom, pixels.
float legends(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const auto& all = ctx.state.viewport.legends;
  const auto layouts = lay_out_legends(all, size.x, size.y, mark_type(ctx));
  if (layouts.empty()) return 0;
  // If room is short, the layout leaves out the first legends.
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

void draw_rim(const PanelContext& ctx, ImVec2 place, const std::string& text) {
  constexpr int kAround = 12;
  const float reach = kMarkOutline * ctx.scale;
  const ImU32 colour = to_u32(ctx.palette.scene);
  for (int k = 0; k < kAround; ++k) {
    const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(k) / kAround;
    ImGui::GetWindowDrawList()->AddText(at(place, reach * std::cos(angle), reach * std::sin(angle)),
                                        colour, text.c_str());
  }
}

float draw_view_marks(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  scale_bar(ctx, corner, size);
  return shows_flat_drawing(ctx.state) ? 0 : legends(ctx, corner, size);
}

void draw_view_labels(PanelContext& ctx) {
  if (shows_flat_drawing(ctx.state)) return;
  draw_clip_handle(ctx);
  const ViewportInfo& v = ctx.state.viewport;
  if (v.labels.empty() || v.texture == 0 || !ctx.state.has_molecule()) return;
  const ImVec2 corner = ImGui::GetWindowPos();
  const LabelLayout layout = lay_out_labels(v.labels, static_cast<float>(v.width),
                                            static_cast<float>(v.height), mark_type(ctx));
  for (const MarkText& text : layout.texts) {
    mark_text(ctx, corner, text, to_u32(ctx.palette.text));
  }
  const std::string left_out = left_out_text(layout.left_out);
  if (left_out.empty()) return;
  const ImVec2 size = ImGui::CalcTextSize(left_out.c_str());
  const MarkText note{(static_cast<float>(v.width) - size.x) / 2,
                      static_cast<float>(v.height) - size.y - ctx.px(14), left_out};
  mark_text(ctx, corner, note, to_u32(ctx.palette.warning));
  ctx.rects["view.labels_left_out"] = {corner.x + note.x, corner.y + note.y,
                                       corner.x + note.x + size.x, corner.y + note.y + size.y,
                                       true};
}

}  // namespace alphascope
