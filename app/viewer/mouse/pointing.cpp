// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the item under the mouse, and selects it on a click. Drags the handle of the clip and balls
// of the sandbox. The wheel resizes such a ball. Elsewhere mouse and wheel move the camera.
#include "app/viewer/mouse/pointing.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "core/complex/own_dimension.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

// Greatest distance from a line that still hits it, pixels at scale 1.
constexpr double kBesideALine = 4;
constexpr double kWheelStep = 0.1;  // Å a notch, if no step is set

double step_of(const ViewState& s) {
  return ImGui::GetIO().KeyAlt ? 0 : s.sandbox.snap_angstrom;
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

std::optional<Pointing::UnderMouse> Pointing::under(int x, int y) const {
  const float scale = frame_.scale();
  const BallReferences* references = state_.references.get();
  if (references == nullptr) return std::nullopt;
  const auto hit = scene_.shown().pick(x, y, kBesideALine * scale);
  if (!hit) return std::nullopt;
  if (hit->layer == kBodies || hit->layer == kTubes) {
    const Layer& layer = scene_.shown().layers().layer_of(*hit);
    return UnderMouse{{}, {layer.name, layer.name}, layer.page, layer.cavity};
  }
  if (hit->layer == kAtomInFront || hit->layer == kAtomOfObject) return under_atom(hit->index);
  if (hit->layer == kBesideBody) {
    const LeftOutAtom& atom = scene_.shown().beside_body().atoms.at(hit->index);
    return UnderMouse{references->atom_of_molecule(atom.atom),
                      describe_atom_beside(*references, atom)};
  }
  if (hit->corners == 1) {
    const auto ball = static_cast<BallIndex>(hit->index);
    const Answer* answer = scene_.drawn().answer.get();
    return UnderMouse{references->atom(ball),
                      describe_ball(*references, answer ? &answer->request : nullptr, ball)};
  }
  const Answer& drawn = *scene_.drawn().answer;
  const HitSimplex simplex =
      hit_simplex(*hit, InOwnDimension(*drawn.balls, drawn.complex).complex());
  return UnderMouse{references->reference(simplex.balls), describe_simplex(*references, simplex)};
}

// An atom that panels draw in front, whether or not it is a ball.
Pointing::UnderMouse Pointing::under_atom(std::size_t atom) const {
  const BallReferences& references = *state_.references;
  const AtomRef ref = references.atom_of_molecule(atom);
  if (const auto ball = references.ball(ref)) {
    const Answer* answer = scene_.drawn().answer.get();
    return {ref, describe_ball(references, answer ? &answer->request : nullptr, *ball)};
  }
  for (const LeftOutAtom& out : references.prepared().left_out) {
    if (out.atom == atom) return {ref, describe_atom_beside(references, out)};
  }
  return {};
}

void Pointing::describe_under_mouse() {
  ViewportInfo& v = state_.viewport;
  v.under_mouse = v.under_mouse_line = {};
  state_.hovered.reset();
  state_.cavities.under_mouse.reset();
  marks_.follow_picture();
  if (!v.hovered) return;
  if (auto found = under(v.mouse_x, v.mouse_y)) {
    v.under_mouse = std::move(found->text.tooltip);
    v.under_mouse_line = std::move(found->text.line);
    state_.hovered = std::move(found->what);
    state_.cavities.under_mouse = found->cavity;
  }
}

void Pointing::open_context_menu() {
  const ViewportInfo& v = state_.viewport;
  const auto found = under(v.mouse_x, v.mouse_y);
  ContextState& menu = state_.context;
  menu.opens = true;
  menu.what = found ? found->what : std::nullopt;
  menu.atoms.clear();
  menu.title = menu.what ? name_of(state_.references->molecule(), *menu.what) : "";
}

void Pointing::click(const PointerEvent& event) {
  if (event.button == 1) return open_context_menu();
  const bool more = event.control || event.shift;
  RefSet& items = state_.settings.selection.items;
  const auto found = under(event.x, event.y);
  if (!found) {
    if (!more) state_.settings.selection.clear();
    return;
  }
  if (!found->page.empty()) state_.window.page = found->page;
  if (!found->what) return;
  const RefSet wanted = more ? items.toggled(*found->what) : RefSet({*found->what});
  if (wanted.size() > Selection::kMostItems) {
    state_.notice = "The selection is full. Clear it first.";
  } else {
    items = wanted;
    state_.settings.selection.note_order();
  }
}

void Pointing::centre_on_it(const PointerEvent& event) {
  const auto found = under(event.x, event.y);
  if (found && found->what) marks_.centre_on(RefSet({*found->what}));
}

// While the user turns the handle, its pivot stays where it was at the press.
void Pointing::place_clip_handle() {
  const float scale = frame_.scale();
  constexpr double kSize = 85;  // pixels at scale 1
  const auto pivot = pivot_near(state_.settings.clip, state_.viewport.box_middle);
  if (state_.mouse.clip_part == HandlePart::none) clip_pivot_.reset();
  if (state_.mouse.clip_part == HandlePart::turn && !clip_pivot_) {
    clip_pivot_ = state_.viewport.clip_handle.pivot;
  }
  state_.viewport.clip_handle = scene_.cameras().clip_handle(
      state_.settings.clip, clip_pivot_.value_or(pivot), kSize * scale);
}

std::optional<std::size_t> Pointing::sandbox_ball_at(int x, int y) const {
  const auto found = under(x, y);
  if (!found || !found->what) return std::nullopt;
  const AtomRef* const atom = std::get_if<AtomRef>(&*found->what);
  if (atom == nullptr || atom->atom >= state_.settings.open.sandbox->balls.size())
    return std::nullopt;
  return atom->atom;
}

bool Pointing::move_view() {
  const std::optional<CameraPlace> before = scene_.cameras().place();
  for (const PointerEvent& event : state_.viewport.events) {
    if (!drag_ball(event)) scene_.pointer(event);
  }
  return scene_.cameras().place() != before;
}

bool Pointing::drag_ball(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (!state_.settings.open.sandbox || shows_flat_drawing(state_)) {
    ball_drag_.reset();
    return false;
  }
  if (event.kind == Kind::release && event.button == 0) {
    return std::exchange(ball_drag_, std::nullopt).has_value();
  }
  const auto ray = scene_.cameras().ray(event.x, event.y);
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
