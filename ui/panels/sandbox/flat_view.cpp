// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the complex that was computed last as a flat drawing. Balls moved since then have an
// outline at their new place.
#include "ui/panels/sandbox/flat_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/settings/request.hpp"
#include "core/document/store/answer.hpp"
#include "ui/panels/sandbox/flat_parts.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/theme.hpp"

namespace alphascope {
namespace {

bool same(const FlatBox& a, const FlatBox& b) {
  return a.low == b.low && a.high == b.high;
}

bool same(const FlatContent& a, const FlatContent& b) {
  return a.discs == b.discs && a.cells == b.cells && a.complex == b.complex && a.chosen == b.chosen;
}

// Makes the shapes if the complex on screen is flat. It may lag behind the sandbox, and not be flat
// yet.
void make_shapes(ViewState& state, const FlatBox& box) {
  SandboxState& m = state.sandbox;
  if (!state.result || !is_flat(*state.result->balls)) {
    m.shapes.clear();
    m.shapes_of = nullptr;
    return;
  }
  FlatContent content = m.content;
  content.chosen = selected_balls(state);
  const std::size_t balls = state.result->balls->size();
  std::erase_if(content.chosen, [balls](BallIndex ball) { return ball >= balls; });
  const bool known =
      m.shapes_of == state.result && same(m.shapes_box, box) && same(m.shapes_content, content);
  if (known) return;
  m.shapes = flat_shapes(*state.result->balls, state.result->complex, box, content);
  m.shapes_of = state.result;
  m.shapes_box = box;
  m.shapes_content = content;
}

void draw_hint(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const char* text =
      "Double-click: a new ball.  Drag a ball to move it, its rim to resize it.  "
      "Wheel: zoom.  Delete: remove.";
  const ImVec2 extent = ImGui::CalcTextSize(text);
  if (extent.x > size.x - ctx.px(240)) return;
  ImGui::GetWindowDrawList()->AddText(
      {corner.x + ctx.px(16), corner.y + size.y - extent.y - ctx.px(14)},
      to_u32(ctx.palette.text_muted), text);
}

}  // namespace

double flat_angstrom_per_pixel(const ViewState& state) {
  const double pixels = state.sandbox.pixels_per_angstrom;
  return pixels > 0 ? 1 / pixels : 0;
}

void draw_flat_view(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ViewState& s = ctx.state;
  SandboxState& m = s.sandbox;
  s.viewport.hovered = false;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene));
  FlatPaper paper(ctx.state.sandbox, corner, size);
  if (!(m.pixels_per_angstrom > 0)) {
    if (!s.result || !is_flat(*s.result->balls)) return;
    paper.fit(box_of(*s.result->balls, s.result->request.alpha_angstrom2));
  }
  flat_mouse(ctx, paper, corner, size);
  make_shapes(s, paper.box());
  draw->PushClipRect(corner, end, true);
  for (const FlatShape& shape : m.shapes) draw_flat_shape(ctx, paper, shape);
  draw_moved_balls(ctx, paper);
  draw_flat_marks(ctx, paper);
  draw_hint(ctx, corner, size);
  draw->PopClipRect();
}

}  // namespace alphascope
