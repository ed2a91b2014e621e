// SPDX-License-Identifier: GPL-3.0-or-later
// The clip in the picture. A worker makes the caps that close cut tetrahedra. Plane and caps change
// together, so that no picture shows open tetrahedra.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/run/worker.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

// Caps with what the scene and the mouse need of them.
struct ReadyCaps {
  Clip clip;
  std::shared_ptr<const CapMesh> mesh;  // null: the clip cuts nothing that has caps
  std::optional<PickLayer> pick;
  std::shared_ptr<CapData> data;
};
// Any thread may call it.
ReadyCaps ready_caps(const Clip& clip, std::shared_ptr<const CapMesh> mesh);

class ClipCaps {
 public:
  // `wake` and `finishes` as in Worker.
  ClipCaps(std::function<void()> wake, std::chrono::milliseconds finishes, Canvas& canvas,
           DrawnPicture& picture)
      : canvas_(canvas), picture_(picture), worker_(std::move(wake), finishes) {}

  // The picture follows when the caps are ready.
  void set(const Clip& clip);
  // Shows the caps of a new mesh. Makes others if another clip is set by now.
  void show_new(ReadyCaps caps);
  // Call when the scene has dropped its mesh.
  void forget();
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }

  const std::optional<PickLayer>& pick() const { return pick_; }

 private:
  void submit();
  void show(ReadyCaps caps);

  Canvas& canvas_;
  DrawnPicture& picture_;
  Clip wanted_;
  std::optional<PickLayer> pick_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
