// Picking in the picture, and marks of the selection.
#include <algorithm>
#include <numeric>

#include "app/viewer/scene/scene_controller.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

// The radius of a mark is kMarkScale times the ball's plus kMarkRim (Å), so that it covers the
// ball.
constexpr float kMarkScale = 1.06f, kMarkRim = 0.05f;
// Least radius of marks, for balls that are not drawn because alpha is too low or balls are off.
constexpr float kLeastMark = 0.35f;  // Å

}  // namespace

std::optional<Hit> SceneController::pick(int x, int y, double near) const {
  if (!drawn_molecule_ || width_ == 0 || draws_nothing()) return std::nullopt;
  const Ray ray = scene_.ray(x, y);
  const PickLine line{ray, near * pixel_spread(scene_.sight(), height_),
                      scene_style().cut.along(ray), scene_style().rod_radius};
  if (drawn_layers_.atoms) {
    if (const auto hit = drawn_layers_.atoms->pick(line)) return hit;
  }
  PickLayers layers = picks_;
  if (display_.balls) {
    layers.insert(layers.begin(), {"balls", [this](const PickLine& l) -> std::optional<Hit> {
                                     const auto ball = drawn_molecule_->picker->pick(
                                         radii_, pick_margin_, l.ray, l.kept);
                                     if (!ball) return std::nullopt;
                                     return Hit{"balls", 1, ball->ball, {}, ball->depth, {}};
                                   }});
  }
  if (drawn_caps_.pick) layers.push_back(*drawn_caps_.pick);
  if (beside_body_pick_) layers.push_back(*beside_body_pick_);
  layers.insert(layers.end(), drawn_layers_.picks.begin(), drawn_layers_.picks.end());
  return nearest_hit(layers, line);
}

std::optional<Ray> SceneController::ray(int x, int y) const {
  if (!drawn_molecule_ || width_ == 0 || draws_nothing()) return std::nullopt;
  Ray ray = scene_.ray(x, y);
  for (std::size_t k = 0; k < 3; ++k) ray.start[k] += drawn_molecule_->geometry->origin[k];
  return ray;
}

void SceneController::set_selected(const Selected& selected) {
  if (selected == selected_) return;
  selected_ = selected;
  draw_selected();
}

BallGeometry SceneController::drawn_places(const Selected& what) const {
  BallGeometry places;
  const auto add = [&places](const BallGeometry& from, std::size_t i) {
    places.centres.push_back(from.centres.at(i));
    places.radii.push_back(from.radii.at(i));
  };
  for (const BallIndex ball : what.balls) add(*drawn_molecule_->geometry, ball);
  for (const std::size_t i : what.beside) add(*beside_body_.mesh->opaque.spheres, i);
  return places;
}

// Call again after a change of radii or colours.
void SceneController::draw_selected() {
  dirty_ = true;
  if (!drawn_molecule_) return;
  pick_margin_ = drawn_molecule_->picker->margin(radii_);
  Selected seen = selected_;
  if (drawn_looks_) {
    std::erase_if(seen.balls, [this](BallIndex ball) { return drawn_looks_->hides(ball); });
  }
  auto marks = std::make_shared<BallGeometry>(drawn_places(seen));
  std::vector<float> radii;
  for (std::size_t i = 0; i < marks->centres.size(); ++i) {
    const float radius = i < seen.balls.size() ? radii_.at(seen.balls[i]) : marks->radii[i];
    radii.push_back(std::max(kLeastMark, radius * kMarkScale + kMarkRim));
  }
  marks->radii = radii;
  const std::vector<Rgb8> colours(radii.size(), to_rgb8(palette(theme_).selected));
  scene_.set_selected(radii.empty() ? nullptr : make_ball_data(marks, colours, radii),
                      seen.outlines);
}

void SceneController::zoom_to(const Selected& what) {
  if (!drawn_molecule_) return;
  const BallGeometry places = drawn_places(what);
  std::vector<BallIndex> all(places.centres.size());
  if (all.empty()) return;
  std::iota(all.begin(), all.end(), BallIndex{0});
  Viewpoint view = looking_at(places, all, scene_.sight());
  view.least_aspect = scene_.viewpoint().least_aspect;
  scene_.set_viewpoint(view);
  dirty_ = true;
}

void SceneController::centre_on(const Selected& what) {
  if (!drawn_molecule_) return;
  const BallGeometry places = drawn_places(what);
  if (places.centres.empty()) return;
  Viewpoint view = scene_.viewpoint();
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (const auto& centre : places.centres) sum += centre[k];
    const double middle = sum / static_cast<double>(places.centres.size());
    view.position[k] += middle - view.focal_point[k];
    view.focal_point[k] = middle;
  }
  scene_.set_viewpoint(view);
  dirty_ = true;
}

}  // namespace alphascope
