// Views along a direction, and saved cameras by name.
#include <cmath>

#include "app/viewer/scene/scene_controller.hpp"

namespace alphascope {
namespace {

// The upward direction of a view along an axis of the file. It is y along the z axis, and z along
// the others. Null for all other directions.
const std::array<double, 3>* up_of_axis_view(const std::array<double, 3>& towards_viewer) {
  static constexpr std::array<double, 3> kY{0, 1, 0}, kZ{0, 0, 1};
  if (axis_name(towards_viewer).empty()) return nullptr;
  return towards_viewer[2] != 0 ? &kY : &kZ;
}

}  // namespace

void SceneController::look_from(const std::array<double, 3>& towards_viewer) {
  Viewpoint view = scene_.viewpoint();
  const Sight sight = scene_.sight();
  double along_up = 0;
  for (std::size_t k = 0; k < 3; ++k) along_up += sight.up[k] * towards_viewer[k];
  // The upward direction stays. A view from above or below turns the former forward direction
  // upwards.
  const bool from_above = std::fabs(along_up) > 0.9;
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + sight.distance * towards_viewer[k];
    view.up[k] = from_above ? sight.forward[k] : sight.up[k];
  }
  if (const auto* up = up_of_axis_view(towards_viewer)) view.up = *up;
  scene_.set_viewpoint(view);
  dirty_ = true;
}

void SceneController::look_across(const RealPoint& line) {
  const Sight sight = scene_.sight();
  const auto part_across = [&line](const std::array<double, 3>& v) {
    const RealPoint p{v[0], v[1], v[2]};
    return p - dot(p, line) * line;
  };
  RealPoint forward = part_across(sight.forward);
  // A view straight along the line turns to a view from below, in which the line points up.
  if (length(forward) < 0.01) forward = part_across(sight.up);
  forward = unit_vector(forward);
  look_from({-forward.x, -forward.y, -forward.z});
}

void SceneController::zoom(double factor) {
  Viewpoint view = scene_.viewpoint();
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + (view.position[k] - view.focal_point[k]) / factor;
  }
  scene_.set_viewpoint(view);
  dirty_ = true;
}

NamedView SceneController::named_view(const std::string& name) const {
  const Viewpoint view = scene_.viewpoint();
  NamedView named{name,    view.position,     view.focal_point,
                  view.up, view.least_aspect, display_.orthographic};
  for (std::size_t k = 0; drawn_molecule_ && k < 3; ++k) {
    named.position[k] += drawn_molecule_->geometry->origin[k];
    named.focal_point[k] += drawn_molecule_->geometry->origin[k];
  }
  return named;
}

void SceneController::go_to(const NamedView& named) {
  if (!drawn_molecule_) return;
  Viewpoint view{named.position, named.focal_point, named.up, named.least_aspect};
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] -= drawn_molecule_->geometry->origin[k];
    view.focal_point[k] -= drawn_molecule_->geometry->origin[k];
  }
  scene_.set_viewpoint(view);
  dirty_ = true;
}

}  // namespace alphascope
