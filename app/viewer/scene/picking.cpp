// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the line of sight through a pixel against balls, simplices and other layers.
#include "app/viewer/scene/picking.hpp"

namespace alphascope {

void Picking::follow_mesh() {
  forget();
  if (picture_.shows_complex()) polls_before_ = kPollsBefore;
}

void Picking::poll() {
  if (polls_before_ > 0 && --polls_before_ == 0) make_layers();
  worker_.poll();
}

void Picking::make_layers() {
  worker_.submit([this, mesh = picture_.parts.mesh, balls = picture_.molecule->geometry](
                     const RunContext& context) -> Worker::Delivery {
    return [this, mesh, layers = mesh_layers(mesh, balls, context.cancel)] {
      if (mesh == picture_.parts.mesh) mesh_layers_ = layers;
    };
  });
}

void Picking::forget() {
  polls_before_ = 0;
  mesh_layers_.clear();
  worker_.cancel();
}

PickLayer Picking::balls() const {
  return {"balls", [this](const PickLine& line) -> std::optional<Hit> {
            const auto ball =
                picture_.molecule->picker->pick(picture_.parts.radii, margin_, line.ray, line.kept);
            if (!ball) return std::nullopt;
            return Hit{"balls", 1, ball->ball, {}, ball->depth, {}};
          }};
}

std::optional<Hit> Picking::pick(int x, int y, double near,
                                 const std::optional<PickLayer>& in_front,
                                 const PickLayers& others) const {
  if (!picture_.any() || canvas_.width() == 0) return std::nullopt;
  const SceneStyle& style = canvas_.style();
  const Ray ray = canvas_.scene().ray(x, y);
  const PickLine line{ray, near * pixel_spread(canvas_.scene().sight(), canvas_.height()),
                      style.cut.along(ray), style.rod_radius};
  if (in_front) {
    if (const auto hit = in_front->pick(line)) return hit;
  }
  PickLayers layers;
  if (style.balls) layers.push_back(balls());
  layers.insert(layers.end(), mesh_layers_.begin(), mesh_layers_.end());
  layers.insert(layers.end(), others.begin(), others.end());
  return nearest_hit(layers, line);
}

}  // namespace alphascope
