// SPDX-License-Identifier: GPL-3.0-or-later
// The drawn atoms that are not balls of the complex. A worker makes their drawing.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "app/viewer/scene/scene_controls.hpp"
#include "core/run/worker.hpp"
#include "ui/scene/mesh/beside_body.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

class BesideAtoms {
 public:
  // `wake` as in Worker.
  BesideAtoms(std::function<void()> wake, Canvas& canvas, const DrawnPicture& picture,
              FactsOnce& facts)
      : canvas_(canvas), picture_(picture), facts_(facts), worker_(std::move(wake)) {}

  // Makes the drawing anew. The last drawn atoms stay until the new ones are ready.
  void follow(const SceneControls& controls);
  // Call when the scene has dropped its layers.
  void forget();
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }

  const BesideBody& body() const { return body_; }
  const std::optional<PickLayer>& pick() const { return pick_; }

 private:
  Canvas& canvas_;
  const DrawnPicture& picture_;
  FactsOnce& facts_;
  BesideBody body_;
  std::optional<PickLayer> pick_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
