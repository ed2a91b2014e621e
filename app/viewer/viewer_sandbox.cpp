// Balls of the sandbox in the 3-D picture: dragged by the mouse, resized by the wheel. Elsewhere,
// and for what is no sandbox, mouse and wheel are the camera's.
#include <imgui.h>

#include <algorithm>
#include <variant>

#include "app/viewer/viewer.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"

namespace alphascope {
namespace {

constexpr double kWheelStep = 0.1;  // Å a notch, where the mouse has no step

double step_of(const ViewState& s) {
  return ImGui::GetIO().KeyAlt ? 0 : s.memory.sandbox.snap_angstrom;
}

void resize_by(ViewState& s, std::size_t ball, double notches) {
  Sandbox& sandbox = *s.settings.open.sandbox;
  const double step = step_of(s) > 0 ? step_of(s) : kWheelStep;
  const double radius = snapped(radius_of(sandbox, ball) + notches * step, step_of(s));
  resize_ball(sandbox, ball, std::max(radius, least_sandbox_radius(sandbox.lattice)));
}

void move_to(ViewState& s, std::size_t ball, SandboxPlace place) {
  for (double& coordinate : place) coordinate = snapped(coordinate, step_of(s));
  move_ball(*s.settings.open.sandbox, ball, place);
}

}  // namespace

std::optional<std::size_t> Viewer::sandbox_ball_at(int x, int y) const {
  const auto found = under(x, y);
  if (!found || !found->what) return std::nullopt;
  const AtomRef* const atom = std::get_if<AtomRef>(&*found->what);
  if (atom == nullptr || atom->atom >= state_.settings.open.sandbox->balls.size())
    return std::nullopt;
  return atom->atom;
}

bool Viewer::drag_ball(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (!state_.settings.open.sandbox || shows_flat_drawing(state_)) {
    ball_drag_.reset();
    return false;
  }
  if (event.kind == Kind::release && event.button == 0) {
    return std::exchange(ball_drag_, std::nullopt).has_value();
  }
  const auto ray = scene_.ray(event.x, event.y);
  if (!ray) return false;
  if (event.kind == Kind::move && ball_drag_) {
    if (ball_drag_->ball() >= state_.settings.open.sandbox->balls.size()) ball_drag_.reset();
    const auto place = ball_drag_ ? ball_drag_->place(*ray) : std::nullopt;
    if (place) move_to(state_, ball_drag_->ball(), *place);
    return true;
  }
  const bool takes =
      event.kind == Kind::press && event.button == 0 && !event.control && !event.shift;
  const bool resizes = event.kind == Kind::wheel && event.control;
  if (!takes && !resizes) return false;
  const auto ball = sandbox_ball_at(event.x, event.y);
  if (!ball) return false;
  if (resizes) {
    resize_by(state_, *ball, event.wheel);
    return true;
  }
  const RealPoint& into = state_.viewport.into_view;
  ball_drag_ =
      BallDrag::begin(*state_.settings.open.sandbox, *ball, *ray, {into.x, into.y, into.z});
  return ball_drag_.has_value();
}

}  // namespace alphascope
