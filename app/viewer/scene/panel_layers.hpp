// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of panels in the picture. A worker makes large ones.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/run/worker.hpp"
#include "ui/layer.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/pick/pick.hpp"
#include "ui/scene/picture/picture.hpp"

namespace alphascope {

// Free memory for drawing in bytes, if known. Called from any thread.
using FreeMemory = std::function<std::optional<std::uint64_t>()>;

class PanelLayers {
 public:
  // `wake` as in Worker.
  PanelLayers(std::function<void()> wake, FreeMemory free_memory, Canvas& canvas,
              const DrawnPicture& picture, FactsOnce& facts)
      : free_memory_(std::move(free_memory)),
        canvas_(canvas),
        picture_(picture),
        facts_(facts),
        worker_(std::move(wake)) {}

  // Layers of other balls than those of the complex on screen are left out. The last drawn layers
  // stay until the new ones are ready.
  void set(const Layers& layers);
  // Call when the scene has dropped its layers.
  void forget();
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }

  bool wants_any() const { return !wanted_.empty(); }
  // The drawn layers.
  const Layers& layers() const { return drawn_.layers; }
  Layers for_saved_pictures() const;
  PicturedObjects objects_for_saved_pictures() const;
  const PickLayers& picks() const { return drawn_.picks; }
  // What is picked before all else: atoms in front, then among pale balls named bodies and tubes,
  // and objects.
  const std::optional<PickLayer>& picked_first() const { return picked_first_; }
  // The layer of a hit on kBodies or kTubes.
  const Layer& layer_of(const Hit& hit) const { return *drawn_.layers.at(hit.index); }
  bool fades_rest() const { return drawn_.mesh && drawn_.mesh->fades_rest; }
  const std::string& not_drawn() const { return drawn_.not_drawn; }
  std::uint64_t bytes() const;
  // The labels in a picture of the canvas' size.
  std::vector<PictureLabel> labels() const;

 private:
  struct Drawn {
    Layers layers;
    std::shared_ptr<const LayerMesh> mesh;  // null: none
    std::string not_drawn;                  // why layers are missing; empty: none
    PickLayers picks;                       // of mesh
    std::optional<PickLayer> atoms;         // of mesh
    struct Object {
      PicturedObject pictured;
      std::shared_ptr<ObjectData> data;
      bool in_pictures = true;
    };
    std::vector<Object> objects;
  };
  // Makes the layers' objects and their picks.
  void add_objects(Drawn& drawn, const DrawnMolecule& molecule, const RunContext& context) const;
  void submit(const Layers& layers);
  void show(Drawn drawn, std::shared_ptr<LayerData> data);
  std::optional<PickLayer> find_picked_first() const;

  const FreeMemory free_memory_;
  Canvas& canvas_;
  const DrawnPicture& picture_;
  FactsOnce& facts_;
  std::vector<std::pair<std::string, std::uint64_t>> wanted_;  // ids and keys
  Drawn drawn_;
  std::optional<PickLayer> picked_first_;  // of drawn_
  Worker worker_;                          // last member, so that its thread is joined first
};

}  // namespace alphascope
