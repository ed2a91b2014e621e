// SPDX-License-Identifier: GPL-3.0-or-later
// Takes over answers and controls, has drawings made, and draws the picture.
#include "app/viewer/scene/scene_controller.hpp"

#include <new>
#include <utility>

#include "core/radii/amber_radii.hpp"
#include "ui/scene/display_style.hpp"

namespace alphascope {
namespace {

constexpr const char* kStandIn = "Balls are left out while the view moves.";
// A mesh newer than the one on screen is always finished. Otherwise a slow mesh would never appear
// while the slider moves. set_molecule() cancels meshes of another molecule.
constexpr std::chrono::milliseconds kFinishes = std::chrono::hours(24);

}  // namespace

SceneController::SceneController(std::function<void()> wake, FreeMemory free_memory,
                                 MeshMaker make_mesh)
    : free_memory_(std::move(free_memory)),
      make_mesh_(std::move(make_mesh)),
      shown_(wake, kFinishes, free_memory_, controls_),
      maker_(wake, kFinishes, free_memory_, make_mesh_,
             {[this](Drawing drawing) { take(std::move(drawing)); }, [this] { make_room(); },
              [this](const std::shared_ptr<const OpenedMolecule>& opened) {
                if (opened == opened_) show_no_memory();
              },
              [this](const std::string& why) { show_nothing("Nothing is drawn: " + why); }}) {}

std::shared_ptr<const Molecule> SceneController::molecule() const {
  return opened_ ? opened_->molecule : nullptr;
}

void SceneController::set_molecule(std::shared_ptr<const OpenedMolecule> opened) {
  waiting_ = cameras().is_set_for(*opened);
  maker_.cancel();
  opened_ = std::move(opened);
  answer_ = nullptr;
  agreement_ = nullptr;
  if (!waiting_) submit();
}

void SceneController::close() {
  maker_.cancel();
  opened_ = nullptr;
  answer_ = nullptr;
  agreement_ = nullptr;
  waiting_ = false;
  pending_ = false;
  view_problem_ = ViewProblem::none;
  cameras().forget();
  shown_.clear();
  shown_.forget_not_drawn();
}

void SceneController::set_answer(std::shared_ptr<const Answer> answer) {
  if (!answer || !opened_ || answer->prepared != opened_->prepared) return;
  answer_ = std::move(answer);
  agreement_ = nullptr;
  waiting_ = false;
  submit();
}

void SceneController::set_agreement(std::shared_ptr<const Agreement> agreement) {
  if (!agreement || agreement->ours != answer_ || agreement->comparison.identical()) return;
  agreement_ = std::move(agreement);
  submit();
}

void SceneController::show_without_answer() {
  if (!opened_ || answer_) return;
  // This is called in each frame, so it must not start a drawing that is in progress.
  const bool there = drawn().molecule && drawn().molecule->prepared == opened_->prepared;
  if (!waiting_ && (there || maker_.busy())) return;
  waiting_ = false;
  submit();
}

void SceneController::set_display(const DisplaySettings& display, Theme theme, float line_scale) {
  const bool same = controls_.display == display && controls_.theme == theme &&
                    controls_.line_scale == line_scale;
  if (same) return;
  const SceneControls before = controls_;
  controls_.display = display;
  controls_.theme = theme;
  controls_.line_scale = line_scale;
  shown_.follow_display(before);
  const bool new_paint = before.display.complex_paint != display.complex_paint;
  if (new_paint || mesh_options(display, theme) != requested_mesh_) submit();
}

void SceneController::set_clip(const Clip& clip) {
  controls_.clip = clip;
  shown_.caps().set(clip);
}

void SceneController::set_appearance(const Appearance& appearance) {
  if (std::exchange(controls_.appearance, appearance) == appearance) return;
  submit();
  shown_.follow_beside();
  shown_.follow_objects();
}

void SceneController::set_objects(const DrawnObjects& objects) {
  if (std::exchange(controls_.objects, objects) == objects) return;
  shown_.follow_objects();
}

void SceneController::submit() {
  requested_mesh_ = mesh_options(controls_.display, controls_.theme);
  if (!opened_ || waiting_) return;  // the awaited drawing will use the new options
  maker_.make({opened_, answer_, agreement_, controls_, drawn().molecule, drawn().parts.paintings});
}

// Removes the picture from the scene and tries again. The last image stays, marked as outdated.
void SceneController::make_room() {
  shown_.clear();
  if (opened_) submit();
}

void SceneController::show_nothing(const std::string& why) {
  Drawing nothing;
  nothing.molecule = make_undrawn(opened_);
  nothing.answer = answer_;
  nothing.not_drawn = why;
  shown_.show(std::move(nothing));
}

void SceneController::show_no_memory() {
  show_nothing(std::string(kNothingDrawn) + " Choose" + kShowLess);
}

void SceneController::take(Drawing drawing) {
  if (!opened_ || drawing.molecule->prepared != opened_->prepared) return;
  if (drawing.parts.mesh) {
    const std::string beyond =
        beyond_opengl_text(*drawing.parts.mesh, drawing.molecule->geometry->centres.size(),
                           shown_.canvas().scene().most_cells());
    if (!beyond.empty()) {
      drawing.parts.mesh = nullptr;
      drawing.mesh = nullptr;
      drawing.not_drawn = beyond;
    }
  }
  try {
    shown_.show(std::move(drawing));
  } catch (const std::bad_alloc&) {
    show_no_memory();
  }
}

void SceneController::pointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::click || event.kind == PointerEvent::Kind::double_click) {
    return;
  }
  cameras().end_glide();
  Scene& scene = shown_.canvas().change();
  if (event.kind == PointerEvent::Kind::wheel) return scene.wheel(event.wheel);
  scene.pointer_move(event.x, event.y, event.control, event.shift);
  if (event.kind == PointerEvent::Kind::move) return;
  constexpr PointerButton kButtons[] = {PointerButton::left, PointerButton::right,
                                        PointerButton::middle};
  scene.pointer_button(kButtons[event.button], event.kind == PointerEvent::Kind::press);
}

bool SceneController::poll() {
  const std::shared_ptr<const Answer> before = drawn().answer;
  maker_.poll();
  shown_.poll();
  return before != drawn().answer;
}

bool SceneController::draws_outer_faces() const {
  return mesh_options(controls_.display, controls_.theme).outside();
}

double SceneController::seconds_to_refinement() const {
  return covered_ ? Pacing::kNotDue : shown_.pacing().seconds_to_refinement();
}

void SceneController::describe(ViewportInfo& viewport) const {
  const bool balls = controls_.display.balls;
  drawn().describe(balls, viewport);
  viewport.not_drawn = drawn().lacks(balls);
  const auto add = [&viewport](const std::string& sentence) {
    viewport.not_drawn += (viewport.not_drawn.empty() ? "" : " ") + sentence;
  };
  if (!shown_.layers().not_drawn().empty()) add(shown_.layers().not_drawn());
  if (!shown_.objects().not_drawn().empty()) add(shown_.objects().not_drawn());
  if (shown_.canvas().without_balls()) add(kStandIn);
  viewport.fades_rest = shown_.layers().fades_rest();
  viewport.problem = view_problem_;
  const std::array<double, 3> forward = shown_.canvas().scene().sight().forward;
  viewport.into_view = {forward[0], forward[1], forward[2]};
}

void SceneController::render(ViewportInfo& viewport, bool interacting, bool patient) {
  // A picture of balls that wait for their first complex does not count as outdated.
  const bool first = opened_ && drawn().molecule &&
                     drawn().molecule->prepared == opened_->prepared && !drawn().answer;
  const bool old = viewport.texture != 0 && !first && (pending_ || outdated());
  viewport.outdated = shown_.pacing().note_age(old);
  if (!Canvas::is_large_enough(viewport.width, viewport.height) || !drawn().molecule) return;
  Canvas& canvas = shown_.canvas();
  canvas.resize(viewport.width, viewport.height);
  covered_ = viewport.covered && canvas.scene().view_is_set();
  if (covered_) return;
  view_checked_ = view_checked_ && !canvas.changed();
  try {
    if (shown_.pacing().draw_when_due(interacting, pending_, patient)) {
      viewport.texture = canvas.scene().texture();
      viewport.angstrom_per_pixel = drawn().any() ? canvas.scene().angstrom_per_pixel() : 0;
      viewport.labels = shown_.layers().labels();
    }
  } catch (const std::bad_alloc&) {
    return show_no_memory();
  }
  check_view(viewport, interacting);
}

void SceneController::begin_picture(ViewportInfo& viewport, bool interacting) {
  const bool new_one = shown_.pacing().has_new_picture() && !covered_;
  const bool layers = shown_.layers().wants_any();
  // The panels of this frame can show the first picture only if it is there before them.
  const bool first = viewport.texture == 0;
  const bool meanwhile = shown_.canvas().scene().renders_asynchronously();
  if (!new_one || layers || (!first && !meanwhile)) return;
  render(viewport, interacting, false);
}

// Does nothing while the user moves the view, since a view on its way may show nothing.
void SceneController::check_view(ViewportInfo& viewport, bool interacting) {
  if (interacting || std::exchange(view_checked_, true)) return;
  viewport.problem = view_problem_ = shown_.view_problem();
}

bool SceneController::outdated() const {
  if (!drawn().molecule) return opened_ != nullptr;
  return drawn().molecule->prepared != opened_->prepared || (answer_ && drawn().answer != answer_);
}

}  // namespace alphascope
