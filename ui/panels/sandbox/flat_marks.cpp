// SPDX-License-Identifier: GPL-3.0-or-later
// Marks over the flat drawing: moved balls, selected balls, and the ball under the mouse.
#include <algorithm>
#include <string>

#include "core/document/settings/open_options.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/sandbox/flat_parts.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void draw_moved_balls(PanelContext& ctx, const FlatPaper& paper) {
  const ViewState& s = ctx.state;
  if (!s.shown_selection()) return;
  const Sandbox& sandbox = *s.settings.open.sandbox;
  const BallSet& drawn = *s.shown_selection()->balls;
  for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
    const SandboxBall& ball = sandbox.balls[i];
    const bool there = i < drawn.size() && drawn.lattice == sandbox.lattice &&
                       drawn.centres[i] == ball.centre && drawn.radii[i] == ball.radius;
    if (there) continue;
    const SandboxPlace at = centre_of(sandbox, i);
    ImGui::GetWindowDrawList()->AddCircle(
        paper.pixel({at[0], at[1]}),
        paper.pixels(radius_of(sandbox, i) + s.solvent_radius_angstrom()),
        to_u32(ctx.palette.accent, 0.8f), 64, ctx.px(1));
  }
}

void draw_flat_marks(PanelContext& ctx, const FlatPaper& paper) {
  const SandboxState& m = ctx.state.sandbox;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto ring = [&](std::size_t ball, ImU32 ink, float width) {
    const SandboxPlace at = centre_of(sandbox, ball);
    draw->AddCircle(paper.pixel({at[0], at[1]}),
                    paper.pixels(radius_of(sandbox, ball) + ctx.state.solvent_radius_angstrom()),
                    ink, 96, ctx.px(width));
  };
  for (const BallIndex ball : selected_balls(ctx.state)) {
    ring(ball, to_u32(ctx.palette.selected), 2.5f);
  }
  const FlatPart part = m.held != FlatPart::none ? m.held : m.hovered;
  const bool on_ball = part == FlatPart::centre || part == FlatPart::rim;
  if (!on_ball || m.ball >= sandbox.balls.size()) return;
  ring(m.ball, to_u32(ctx.palette.accent_hovered), part == FlatPart::rim ? 3 : 1.5f);
  ImGui::SetMouseCursor(part == FlatPart::rim ? ImGuiMouseCursor_ResizeEW
                                              : ImGuiMouseCursor_ResizeAll);
  const SandboxPlace at = centre_of(sandbox, m.ball);
  const std::string text = "Ball " + std::to_string(m.ball + 1) + ":  x " + number_text(at[0], 3) +
                           "  y " + number_text(at[1], 3) + "  r " +
                           number_text(radius_of(sandbox, m.ball), 3) + " Å";
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  const float most_right = ImGui::GetWindowPos().x + ImGui::GetWindowSize().x - ctx.px(8);
  const ImVec2 place{std::min(mouse.x + ctx.px(16), most_right - extent.x), mouse.y + ctx.px(14)};
  draw->AddRectFilled({place.x - ctx.px(5), place.y - ctx.px(3)},
                      {place.x + extent.x + ctx.px(5), place.y + extent.y + ctx.px(3)},
                      to_u32(ctx.palette.panel_raised, 0.92f), ctx.px(4));
  draw->AddText(place, to_u32(ctx.palette.text), text.c_str());
}

}  // namespace alphascope
