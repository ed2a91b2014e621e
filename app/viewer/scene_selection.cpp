// What is under the mouse in the picture, and what of it is selected.
#include <algorithm>

#include "app/viewer/scene_controller.hpp"
#include "ui/scene/ball_colours.hpp"

namespace alphascope {
namespace {

// A selected ball covers the ball that it marks.
constexpr float kMarkScale = 1.06f, kMarkRim = 0.05f;  // times the radius, and Å
// Balls that are not drawn, since alpha leaves nothing of them or balls are off, are marked so
// large.
constexpr float kLeastMark = 0.35f;  // Å

}  // namespace

std::optional<Hit> SceneController::pick(int x, int y, double near) const {
  if (!drawn_molecule_ || width_ == 0 || draws_nothing()) return std::nullopt;
  const PickLine line{scene_.ray(x, y), near * 2 * scene_.sight().tangent_up / height_};
  PickLayers layers = picks_;
  if (display_.balls) {
    layers.insert(layers.begin(), {"balls", [this](const PickLine& l) -> std::optional<Hit> {
                                     const auto ball =
                                         drawn_molecule_->picker->pick(radii_, pick_margin_, l.ray);
                                     if (!ball) return std::nullopt;
                                     return Hit{"balls", 1, ball->ball, {}, ball->depth, {}};
                                   }});
  }
  return nearest_hit(layers, line);
}

void SceneController::set_selected(const std::vector<BallIndex>& balls) {
  if (balls == selected_) return;
  selected_ = balls;
  draw_selected();
}

// Also when radii or colours have changed.
void SceneController::draw_selected() {
  dirty_ = true;
  if (!drawn_molecule_) return;
  pick_margin_ = drawn_molecule_->picker->margin(radii_);
  auto marks = std::make_shared<BallGeometry>();
  std::vector<float> radii;
  for (const BallIndex ball : selected_) {
    marks->centres.push_back(drawn_molecule_->geometry->centres.at(ball));
    radii.push_back(std::max(kLeastMark, radii_.at(ball) * kMarkScale + kMarkRim));
  }
  marks->radii = radii;
  const std::vector<Rgb8> colours(radii.size(), to_rgb8(palette(theme_).selected));
  scene_.set_selected(radii.empty() ? nullptr : make_ball_data(marks, colours, radii));
}

void SceneController::zoom_to(const std::vector<BallIndex>& balls) {
  if (!drawn_molecule_ || balls.empty()) return;
  Viewpoint view = looking_at(*drawn_molecule_->geometry, balls, scene_.sight());
  view.least_aspect = scene_.viewpoint().least_aspect;
  scene_.set_viewpoint(view);
  dirty_ = true;
}

}  // namespace alphascope
