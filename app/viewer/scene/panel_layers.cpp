// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the drawings of layers, small ones at once.
#include "app/viewer/scene/panel_layers.hpp"

#include <algorithm>
#include <iterator>

#include "ui/layer_objects.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/picture/placed_label.hpp"

namespace alphascope {
namespace {

// Largest number of points of layers that are made between two frames, in one or two milliseconds.
// A worker makes larger layers.
constexpr std::size_t kMostPointsAtOnce = 60000;

}  // namespace

void PanelLayers::set(const Layers& layers) {
  Layers fitting;
  std::vector<std::pair<std::string, std::uint64_t>> keys;
  for (const auto& layer : layers) {
    if (!picture_.answer || layer->balls != picture_.answer->balls) continue;
    fitting.push_back(layer);
    keys.emplace_back(layer->id, layer->key);
  }
  if (picture_.draws_nothing()) fitting.clear(), keys.clear();
  if (keys == wanted_) return;
  wanted_ = keys;
  worker_.cancel();
  if (fitting.empty()) return show({}, nullptr);
  const bool objects = std::any_of(fitting.begin(), fitting.end(),
                                   [](const auto& layer) { return layer->objects != nullptr; });
  if (objects || layer_points(fitting).all() > kMostPointsAtOnce) return submit(fitting);
  auto mesh =
      std::make_shared<const LayerMesh>(build_layer_mesh(*picture_.molecule->geometry, fitting));
  show({fitting, mesh, {}, body_layers(mesh), atom_layer(mesh), {}}, make_layer_data(mesh));
}

void PanelLayers::submit(const Layers& layers) {
  const auto tell = [this](const std::string& why) {
    show({{}, nullptr, why, {}, {}, {}}, nullptr);
  };
  worker_.submit(
      [this, tell, layers,
       molecule = picture_.molecule](const RunContext& context) -> Worker::Delivery {
        const std::string not_drawn = layers_not_drawn_text(layer_points(layers), free_memory_());
        if (!not_drawn.empty()) return [tell, not_drawn] { tell(not_drawn); };
        auto mesh =
            std::make_shared<const LayerMesh>(build_layer_mesh(*molecule->geometry, layers));
        Drawn drawn{layers, mesh, {}, body_layers(mesh), atom_layer(mesh), {}};
        add_objects(drawn, *molecule, context);
        return [this, molecule, drawn, data = make_layer_data(mesh)] {
          if (molecule == picture_.molecule) show(drawn, data);
        };
      },
      [tell](const Worker::Failure& failure) {
        if (!failure.cancelled)
          tell("The drawings of the page below cannot be made: " + failure.message);
      });
}

void PanelLayers::show(Drawn drawn, std::shared_ptr<LayerData> data) {
  Scene& scene = canvas_.change();
  scene.set_layers(std::move(data));
  std::vector<SceneObject> objects;
  for (const Drawn::Object& o : drawn.objects) {
    objects.push_back({o.data, o.pictured.opacity, o.pictured.in_front});
  }
  scene.set_objects(ObjectGroup::layers, std::move(objects));
  drawn_ = std::move(drawn);
  picked_first_ = find_picked_first();
}

void PanelLayers::add_objects(Drawn& drawn, const DrawnMolecule& molecule,
                              const RunContext& context) const {
  for (const auto& layer : drawn.layers) {
    if (!layer->objects) continue;
    for (const LayerObject& o : layer->objects->of) {
      auto mesh = std::make_shared<const ObjectMesh>(build_object(
          molecule, *facts_.of(molecule, context), o.object, o.atoms, {}, context.cancel));
      const PickLayers picks = object_layers(mesh);
      drawn.picks.insert(drawn.picks.end(), picks.begin(), picks.end());
      drawn.objects.push_back(
          {{mesh, o.object.opacity, o.in_front}, make_object_data(mesh), layer->in_pictures});
    }
  }
}

PicturedObjects PanelLayers::objects_for_saved_pictures() const {
  PicturedObjects objects;
  for (const Drawn::Object& o : drawn_.objects) {
    if (o.in_pictures) objects.push_back(o.pictured);
  }
  return objects;
}

void PanelLayers::forget() {
  worker_.cancel();
  wanted_.clear();
  drawn_ = {};
  picked_first_.reset();
}

Layers PanelLayers::for_saved_pictures() const {
  Layers layers;
  for (const auto& layer : drawn_.layers) {
    if (layer->in_pictures) layers.push_back(layer);
  }
  return layers;
}

std::optional<PickLayer> PanelLayers::find_picked_first() const {
  const PickLayers among_pale = fades_rest() ? drawn_.picks : PickLayers{};
  if (!drawn_.atoms && among_pale.empty()) return std::nullopt;
  return PickLayer{kAtomInFront,
                   [atoms = drawn_.atoms, among_pale,
                    layers = drawn_.layers](const PickLine& line) -> std::optional<Hit> {
                     if (atoms) {
                       if (const std::optional<Hit> hit = atoms->pick(line)) return hit;
                     }
                     const std::optional<Hit> hit = nearest_hit(among_pale, line);
                     const bool of_layer = hit && (hit->layer == kBodies || hit->layer == kTubes);
                     if (of_layer && layers.at(hit->index)->name.empty()) return std::nullopt;
                     return hit;
                   }};
}

std::uint64_t PanelLayers::bytes() const {
  return layer_bytes(layer_points(drawn_.layers));
}

std::vector<PictureLabel> PanelLayers::labels() const {
  if (!drawn_.mesh) return {};
  return labels_seen(drawn_.mesh->labels, canvas_.scene().sight(), canvas_.style().cut,
                     canvas_.width(), canvas_.height());
}

}  // namespace alphascope
