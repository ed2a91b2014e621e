// Views along a direction, and saved cameras by name.
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/scene/view_direction.hpp"

namespace alphascope {

void SceneController::look_from(const std::array<double, 3>& towards_viewer) {
  scene_.set_viewpoint(view_of_side(scene_.viewpoint(), scene_.sight(), towards_viewer));
  dirty_ = true;
}

void SceneController::look_across(const RealPoint& line) {
  const Sight sight = scene_.sight();
  scene_.set_viewpoint(view_from(scene_.viewpoint(), sight, side_across(sight, line)));
  dirty_ = true;
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
