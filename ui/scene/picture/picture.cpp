// SPDX-License-Identifier: GPL-3.0-or-later
// Hands the parts of a picture to a scene.
#include "ui/scene/picture/picture.hpp"

#include <utility>
#include <vector>

#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/scene_data.hpp"

namespace alphascope {

MarkedPicture show(Scene& scene, const Picture& p) {
  scene.set_style(p.style);
  scene.set_balls(make_ball_data(p.balls, p.colours, p.radii));
  scene.set_mesh(make_mesh_data(p.mesh));
  scene.set_caps(make_cap_data(p.caps));
  scene.set_differences(make_difference_data(p.differences));
  const auto layers = std::make_shared<const LayerMesh>(build_layer_mesh(*p.balls, p.layers));
  scene.set_layers(make_layer_data(layers));
  scene.set_beside_body(make_layer_data(p.beside_body));
  std::vector<SceneObject> objects;
  for (const PicturedObject& o : p.objects)
    objects.push_back({make_object_data(o.mesh), o.opacity});
  scene.set_objects(ObjectGroup::settings, std::move(objects));
  std::vector<SceneObject> of_layers;
  for (const PicturedObject& o : p.layer_objects) {
    of_layers.push_back({make_object_data(o.mesh), o.opacity, o.in_front});
  }
  scene.set_objects(ObjectGroup::layers, std::move(of_layers));
  if (p.viewpoint) scene.set_viewpoint(*p.viewpoint);
  MarkedPicture marked = p.picture;
  marked.labels = layers->labels;
  return marked;
}

}  // namespace alphascope
