// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse on the flat drawing: it moves, resizes and adds balls, and moves and scales the paper.
#include <algorithm>
#include <cmath>

#include "core/document/settings/open_options.hpp"
#include "core/molecule/sandbox.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/sandbox/flat_parts.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Pixels at scale 1; the mouse takes centres and rims within this distance.
constexpr float kReach = 7;
constexpr double kZoomStep = 1.15;  // factor for a notch of the wheel

// Finds the centre or rim under the mouse. A centre precedes a rim, and the nearest wins.
void look_under(PanelContext& ctx, const FlatPaper& paper, ImVec2 mouse) {
  SandboxState& m = ctx.state.sandbox;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  m.hovered = FlatPart::paper;
  float nearest = ctx.px(kReach);
  for (const FlatPart part : {FlatPart::centre, FlatPart::rim}) {
    for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
      const SandboxPlace at = centre_of(sandbox, i);
      const ImVec2 centre = paper.pixel({at[0], at[1]});
      const float distance = std::hypot(mouse.x - centre.x, mouse.y - centre.y);
      const float rim = paper.pixels(radius_of(sandbox, i) + ctx.state.solvent_radius_angstrom());
      const float off = part == FlatPart::centre ? distance : std::fabs(distance - rim);
      if (off >= nearest) continue;
      nearest = off;
      m.hovered = part;
      m.ball = i;
    }
    if (m.hovered == FlatPart::centre) return;
  }
}

// If no centre or rim is near, finds the smallest ball around the mouse. A drag then moves it as by
// its centre.
void look_inside(PanelContext& ctx, const FlatPaper& paper, ImVec2 mouse) {
  SandboxState& m = ctx.state.sandbox;
  if (m.hovered != FlatPart::paper) return;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  const FlatPoint p = paper.place(mouse);
  double least = 1e300;
  for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
    const SandboxPlace at = centre_of(sandbox, i);
    const double radius = radius_of(sandbox, i) + ctx.state.solvent_radius_angstrom();
    if (std::hypot(p[0] - at[0], p[1] - at[1]) >= radius || radius >= least) continue;
    least = radius;
    m.hovered = FlatPart::centre;
    m.ball = i;
  }
}

void take_hold(PanelContext& ctx, const FlatPoint& mouse) {
  SandboxState& m = ctx.state.sandbox;
  m.held = m.hovered;
  if (m.held == FlatPart::paper) {
    m.grip = mouse;
    return;
  }
  if (m.held == FlatPart::none) return;
  select_ball(ctx.state, m.ball, ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl);
  const SandboxPlace at = centre_of(*ctx.state.settings.open.sandbox, m.ball);
  m.grip = {at[0] - mouse[0], at[1] - mouse[1]};
}

void drag(PanelContext& ctx, const FlatPoint& mouse) {
  SandboxState& m = ctx.state.sandbox;
  Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  if (m.held == FlatPart::paper) {
    for (int d = 0; d < 2; ++d) m.middle[d] -= mouse[d] - m.grip[d];
    return;
  }
  if (m.ball >= sandbox.balls.size()) {  // the ball is gone after an undo
    m.held = FlatPart::none;
    return;
  }
  const double step = ImGui::GetIO().KeyAlt ? 0 : m.snap_angstrom;
  if (m.held == FlatPart::centre) {
    move_ball(sandbox, m.ball,
              {snapped(mouse[0] + m.grip[0], step), snapped(mouse[1] + m.grip[1], step), 0});
  } else {
    const SandboxPlace at = centre_of(sandbox, m.ball);
    const double radius =
        std::hypot(mouse[0] - at[0], mouse[1] - at[1]) - ctx.state.solvent_radius_angstrom();
    resize_ball(sandbox, m.ball, std::max(snapped(radius, step), step));
  }
}

void add_at(PanelContext& ctx, const FlatPoint& mouse) {
  ViewState& s = ctx.state;
  Sandbox& sandbox = *s.settings.open.sandbox;
  const SandboxState& m = s.sandbox;
  if (sandbox.balls.size() >= kMostSandboxBalls) {
    s.show_error("There is no room for another ball", why_no_sandbox(sandbox.balls.size() + 1),
                 ErrorKind::request);
    return;
  }
  const double step = ImGui::GetIO().KeyAlt ? 0 : m.snap_angstrom;
  select_ball(s, add_ball(sandbox, {snapped(mouse[0], step), snapped(mouse[1], step), 0},
                          m.next_radius_angstrom));
}

}  // namespace

void flat_mouse(PanelContext& ctx, FlatPaper& paper, ImVec2 corner, ImVec2 size) {
  ViewState& s = ctx.state;
  SandboxState& m = s.sandbox;
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("##flat", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  record(ctx, "view");
  const ImGuiIO& io = ImGui::GetIO();
  const bool on_paper = ImGui::IsItemHovered();
  if (!ImGui::IsMouseDown(0)) m.held = FlatPart::none;
  if (on_paper && io.MouseWheel != 0) paper.zoom(io.MousePos, std::pow(kZoomStep, io.MouseWheel));
  const FlatPoint mouse = paper.place(io.MousePos);
  if (m.held != FlatPart::none) return drag(ctx, mouse);
  m.hovered = FlatPart::none;
  if (!on_paper) return;
  look_under(ctx, paper, io.MousePos);
  look_inside(ctx, paper, io.MousePos);
  if (m.hovered == FlatPart::paper && ImGui::IsMouseDoubleClicked(0)) return add_at(ctx, mouse);
  if (ImGui::IsMouseClicked(0)) {
    if (m.hovered == FlatPart::paper) s.settings.selection.clear();
    return take_hold(ctx, mouse);
  }
}

}  // namespace alphascope
