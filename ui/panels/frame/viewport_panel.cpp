// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view: shows the picture, and lays progress, notes and marks over it. The renderer draws
// the molecule.
#include <cstdint>

#include "ui/panels/frame/running_jobs.hpp"
#include "ui/panels/frame/view_marks.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sandbox/flat_view.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

// Draws the scene's texture as an opaque picture. Its alpha channel reads as one, whatever is
// stored there.
void picture(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const auto texture =
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(ctx.state.viewport.texture));
  if (ctx.state.viewport.texture != 0 && ctx.state.has_molecule()) {
    draw->AddImage(texture, corner, end, {0, 1}, {1, 0});
    if (ctx.state.viewport.outdated) {
      draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene, 0.6f));
    }
  } else {
    draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene));
  }
}

}  // namespace

void draw_viewport(PanelContext& ctx) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  ViewportInfo& v = ctx.state.viewport;
  v.width = static_cast<int>(size.x);
  v.height = static_cast<int>(size.y);
  v.events.clear();
  if (v.width < 8 || v.height < 8) return;
  const bool flat = shows_flat_drawing(ctx.state);
  v.covered = flat;
  if (flat) {
    draw_flat_view(ctx, corner, size);
  } else {
    picture(ctx, corner, size);
    take_view_mouse(ctx, corner, size);
  }
  float legends_height = 0, top = 0;
  if (ctx.state.has_molecule()) {
    legends_height = draw_view_marks(ctx, corner, size);
    draw_view_caption(ctx, corner, size);
    outdated_note(ctx, corner);
    top = hidden_note(ctx, corner, compute_error_note(ctx, corner, size));
  }
  draw_running_jobs(ctx, {corner.x + size.x - ctx.px(14), corner.y + ctx.px(12)});
  if (!flat) view_problem_note(ctx, corner, size, top);
  drop_note(ctx, corner, size, legends_height);
  draw_start_page(ctx, corner, size);
  // Without atoms, a note about things not drawn would say nothing.
  if (!no_atoms_note(ctx, corner, size)) not_drawn_note(ctx, corner, size, legends_height);
  draw_context_menu(ctx);
}

}  // namespace alphascope
