// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of the picture: cartoons, sticks, points. A worker makes their drawings.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "app/viewer/scene/panel_layers.hpp"
#include "app/viewer/scene/scene_controls.hpp"
#include "core/run/worker.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

class MadeObjects {
 public:
  // `wake` as in Worker.
  MadeObjects(std::function<void()> wake, FreeMemory free_memory, Canvas& canvas,
              const DrawnPicture& picture, FactsOnce& facts)
      : free_memory_(std::move(free_memory)),
        canvas_(canvas),
        picture_(picture),
        facts_(facts),
        worker_(std::move(wake)) {}

  // Follows a change of the controls or the balls. A change of opacity alone shows at once; the
  // last drawn objects stay until others are made. Objects that are as before are not made again.
  void follow(const SceneControls& controls);
  // Call when the scene has dropped its objects.
  void forget();
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }

  bool any() const { return !drawn_.empty(); }
  PicturedObjects pictured() const;
  const PickLayers& picks() const { return picks_; }
  const std::string& not_drawn() const { return not_drawn_; }  // why some are missing; empty: none
  std::uint64_t bytes() const;

 private:
  struct Drawn {
    DrawnObject object;
    Appearance appearance;
    std::shared_ptr<const ObjectMesh> mesh;
    std::shared_ptr<ObjectData> data;
    PickLayers picks;
  };
  struct Made {
    std::vector<Drawn> objects;
    std::shared_ptr<const DrawnMolecule> molecule;
    std::string not_drawn;
  };

  static bool same_drawing(const Drawn& drawn, const DrawnObject& object,
                           const Appearance& appearance);
  Made make(Made from, const DrawnObjects& wanted, const Appearance& appearance,
            const RunContext& context) const;
  void show(Made made);
  bool set_opacities(const SceneControls& controls);

  const FreeMemory free_memory_;
  Canvas& canvas_;
  const DrawnPicture& picture_;
  FactsOnce& facts_;
  std::vector<Drawn> drawn_;                 // those that are shown
  std::shared_ptr<const DrawnMolecule> of_;  // the molecule of drawn_
  PickLayers picks_;
  std::string not_drawn_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
