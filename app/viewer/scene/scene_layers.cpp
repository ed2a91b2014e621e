// Layers of panels, and atoms beside the body.
#include <utility>

#include "app/viewer/scene/scene_controller.hpp"

namespace alphascope {
namespace {

// Largest number of points of layers that are made between two frames, in one or two milliseconds.
// A worker makes larger layers.
constexpr std::size_t kMostPointsAtOnce = 60000;

}  // namespace

void SceneController::set_layers(const Layers& layers) {
  Layers fitting;
  std::vector<std::pair<std::string, std::uint64_t>> keys;
  for (const auto& layer : layers) {
    if (!drawn_answer_ || layer->balls != drawn_answer_->balls) continue;
    fitting.push_back(layer);
    keys.emplace_back(layer->id, layer->key);
  }
  if (draws_nothing()) fitting.clear(), keys.clear();
  if (keys == wanted_layers_) return;
  wanted_layers_ = keys;
  layer_worker_.cancel();
  if (fitting.empty()) return show_layers({}, nullptr);
  if (layer_points(fitting).all() > kMostPointsAtOnce) return submit_layers(fitting);
  auto mesh =
      std::make_shared<const LayerMesh>(build_layer_mesh(*drawn_molecule_->geometry, fitting));
  show_layers({fitting, mesh, {}, body_layers(mesh), atom_layer(mesh)}, make_layer_data(mesh));
}

void SceneController::submit_layers(const Layers& layers) {
  const auto tell = [this](const std::string& why) {
    show_layers({{}, nullptr, why, {}, {}}, nullptr);
  };
  layer_worker_.submit(
      [this, tell, layers, drawn = drawn_molecule_](const RunContext&) -> Worker::Delivery {
        const std::string not_drawn = layers_not_drawn_text(layer_points(layers), free_memory_());
        if (!not_drawn.empty()) return [tell, not_drawn] { tell(not_drawn); };
        auto mesh = std::make_shared<const LayerMesh>(build_layer_mesh(*drawn->geometry, layers));
        return [this, layers, drawn, mesh, picks = body_layers(mesh), atoms = atom_layer(mesh),
                data = make_layer_data(mesh)] {
          if (drawn == drawn_molecule_) show_layers({layers, mesh, {}, picks, atoms}, data);
        };
      },
      [tell](const Worker::Failure& failure) {
        if (!failure.cancelled) tell("What is chosen below is not drawn: " + failure.message);
      });
}

void SceneController::show_layers(DrawnLayers layers, std::shared_ptr<LayerData> data) {
  drawn_layers_ = std::move(layers);
  scene_.set_layers(std::move(data));
  dirty_ = true;
}

// The last drawn atoms stay until the new ones are ready.
void SceneController::submit_beside_body() {
  if (!drawn_molecule_ || drawn_molecule_->prepared->left_out.empty()) {
    beside_worker_.cancel();
    return;
  }
  beside_worker_.submit([this, drawn = drawn_molecule_, shown = display_.beside,
                         appearance = appearance_](const RunContext& c) -> Worker::Delivery {
    BesideBody atoms = build_beside_body(
        *drawn->geometry, *drawn->molecule,
        left_out_and_shown(*drawn->molecule, *drawn->prepared, appearance.hidden), shown, c.cancel);
    std::optional<PickLayer> pick;
    if (atoms.mesh) pick = ball_layer(kBesideBody, atoms.mesh->opaque.spheres, 1);
    return [this, drawn, pick, data = make_layer_data(atoms.mesh), atoms] {
      if (drawn != drawn_molecule_) return;
      beside_body_ = atoms;
      beside_body_pick_ = pick;
      scene_.set_beside_body(data);
      dirty_ = true;
    };
  });
}

void SceneController::forget_layers() {
  beside_worker_.cancel();
  beside_body_ = {};
  beside_body_pick_.reset();
  selected_ = {};
  layer_worker_.cancel();
  wanted_layers_.clear();
  drawn_layers_ = {};
}

}  // namespace alphascope
