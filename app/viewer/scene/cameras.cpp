// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the camera, and keeps or fits the view when the balls change.
#include "app/viewer/scene/cameras.hpp"

#include <numeric>
#include <vector>

#include "ui/scene/camera_place.hpp"
#include "ui/scene/view_between.hpp"
#include "ui/scene/view_direction.hpp"

namespace alphascope {
namespace {

constexpr double kGlideSeconds = 0.3;

}  // namespace

void Cameras::settle(const ViewportInfo& viewport) {
  if (canvas_.scene().view_is_set() || !Canvas::is_large_enough(viewport.width, viewport.height)) {
    return;
  }
  canvas_.drawing().apply_pending_reset(viewport.width, viewport.height);
}

std::optional<CameraPlace> Cameras::place() const {
  if (!picture_.any()) return std::nullopt;
  const Viewpoint view = glide_ ? glide_->to : canvas_.scene().viewpoint();
  return camera_place(view, *picture_.molecule->geometry);
}

std::optional<CameraPlace> Cameras::place_of_pictures() const {
  if (!picture_.any()) return std::nullopt;
  return camera_place(canvas_.scene().viewpoint_of_pictures(), *picture_.molecule->geometry);
}

void Cameras::glide(const std::function<void()>& move) {
  const bool seen = picture_.any() && canvas_.scene().view_is_set();
  const Viewpoint before = canvas_.scene().viewpoint();
  end_glide();
  move();
  if (!glides_ || !seen || !canvas_.scene().view_is_set()) return;
  const Viewpoint after = canvas_.scene().viewpoint();
  if (after == before) return;
  canvas_.change().set_viewpoint(before);
  glide_ = Glide{before, after, std::chrono::steady_clock::now()};
}

void Cameras::set_glides(bool glides) {
  glides_ = glides;
  if (!glides) end_glide();
}

void Cameras::step_glide(std::chrono::steady_clock::time_point now) {
  if (!glide_) return;
  const double share = std::chrono::duration<double>(now - glide_->since).count() / kGlideSeconds;
  if (share >= 1) return end_glide();
  const double eased = share <= 0 ? 0 : share * share * (3 - 2 * share);
  canvas_.change().set_viewpoint(view_between(glide_->from, glide_->to, eased));
}

void Cameras::end_glide() {
  if (!glide_) return;
  canvas_.change().set_viewpoint(glide_->to);
  glide_.reset();
}

void Cameras::move(const CameraPlace& camera) {
  canvas_.change().set_viewpoint(viewpoint_at(camera, *picture_.molecule->geometry));
}

void Cameras::look_from(const std::array<double, 3>& towards_viewer) {
  const Scene& scene = canvas_.scene();
  canvas_.change().set_viewpoint(view_of_side(scene.viewpoint(), scene.sight(), towards_viewer));
}

void Cameras::look_across(const RealPoint& line) {
  const ViewFrustum sight = canvas_.scene().sight();
  canvas_.change().set_viewpoint(
      view_from(canvas_.scene().viewpoint(), sight, side_across(sight, line)));
}

void Cameras::zoom(double factor) {
  Viewpoint view = canvas_.scene().viewpoint();
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + (view.position[k] - view.focal_point[k]) / factor;
  }
  canvas_.change().set_viewpoint(view);
}

void Cameras::zoom_to(const BallGeometry& balls) {
  std::vector<BallIndex> all(balls.centres.size());
  if (all.empty()) return;
  std::iota(all.begin(), all.end(), BallIndex{0});
  Viewpoint view = viewpoint_for_balls(balls, all, canvas_.scene().sight());
  view.least_aspect = canvas_.scene().viewpoint().least_aspect;
  canvas_.change().set_viewpoint(view);
}

void Cameras::centre_on(const BallGeometry& balls) {
  if (balls.centres.empty()) return;
  Viewpoint view = canvas_.scene().viewpoint();
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (const auto& centre : balls.centres) sum += centre[k];
    const double middle = sum / static_cast<double>(balls.centres.size());
    view.position[k] += middle - view.focal_point[k];
    view.focal_point[k] = middle;
  }
  canvas_.change().set_viewpoint(view);
}

NamedView Cameras::named(const std::string& name) const {
  const Viewpoint view = canvas_.scene().viewpoint();
  NamedView named{name,    view.position,     view.focal_point,
                  view.up, view.least_aspect, canvas_.style().orthographic};
  for (std::size_t k = 0; picture_.molecule && k < 3; ++k) {
    named.position[k] += picture_.molecule->geometry->origin[k];
    named.focal_point[k] += picture_.molecule->geometry->origin[k];
  }
  return named;
}

void Cameras::go_to(const NamedView& named) {
  if (!picture_.molecule) return;
  Viewpoint view{named.position, named.focal_point, named.up, named.least_aspect};
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] -= picture_.molecule->geometry->origin[k];
    view.focal_point[k] -= picture_.molecule->geometry->origin[k];
  }
  canvas_.change().set_viewpoint(view);
}

std::optional<Ray> Cameras::ray(int x, int y) const {
  if (!picture_.any() || canvas_.width() == 0) return std::nullopt;
  Ray ray = canvas_.scene().ray(x, y);
  for (std::size_t k = 0; k < 3; ++k) ray.start[k] += picture_.molecule->geometry->origin[k];
  return ray;
}

ClipHandle Cameras::clip_handle(const Clip& clip, const std::array<double, 3>& pivot,
                                double size) const {
  if (!clip.on() || !picture_.any() || canvas_.width() == 0) return {};
  const ViewFrustum sight = canvas_.scene().sight();
  HandleView view{sight.right, sight.up, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) view.towards_viewer[k] = -sight.forward[k];
  view.seen = [sight, origin = picture_.molecule->geometry->origin, width = canvas_.width(),
               height = canvas_.height()](const std::array<double, 3>& place) {
    return project_point(sight, {place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]},
                         width, height);
  };
  return make_clip_handle(clip, pivot, view, size);
}

bool Cameras::is_set_for(const OpenedMolecule& opened) const {
  return viewed_ && same_atoms(*viewed_, opened);
}

Cameras::Before Cameras::before(const DrawnMolecule& next) {
  end_glide();
  Before before;
  before.keep = viewed_ && (changes_sandbox(picture_.molecule.get(), next) ||
                            same_atoms(*viewed_, *next.opened));
  before.same_file = viewed_ && viewed_->deposited == next.opened->deposited;
  before.camera = place();
  if (before.keep && picture_.molecule) before.view = named("");
  return before;
}

void Cameras::follow(const Before& before, const std::function<ViewProblem()>& problem) {
  viewed_ = picture_.draws_nothing() ? nullptr : picture_.molecule->opened;
  if (before.view) go_to(*before.view);
  const ViewProblem found = problem();
  const bool shows_none = found != ViewProblem::none && found != ViewProblem::cut_away;
  if (!before.keep || shows_none) {
    if (before.same_file && !when_drawn_) left_ = before.camera;
    reset();
  }
  if (when_drawn_ && !picture_.draws_nothing()) move(*std::exchange(when_drawn_, {}));
}

}  // namespace alphascope
