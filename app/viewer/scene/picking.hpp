// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the thing under the mouse in the picture on screen.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/run/worker.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

class Picking {
 public:
  // `wake` as in Worker.
  Picking(std::function<void()> wake, const Canvas& canvas, const DrawnPicture& picture)
      : canvas_(canvas), picture_(picture), worker_(std::move(wake)) {}

  // Call after a change of the mesh. Until a worker has made its layers, no simplex of it is found.
  // So none is found while alpha moves.
  void follow_mesh();
  // Call after a change of the radii.
  void follow_radii() { margin_ = picture_.molecule->picker->margin(picture_.parts.radii); }
  // Call when the scene has dropped its mesh.
  void forget();
  void poll();  // at least once a frame, before it is drawn
  bool busy() const { return worker_.activity().busy; }
  bool is_due() const { return polls_before_ > 0; }  // one of the next polls begins its work

  // The nearest thing at a pixel, or an atom of `in_front`. `others` are the layers beside balls
  // and mesh. `near`: distance in pixels at which a line is still hit.
  std::optional<Hit> pick(int x, int y, double near, const std::optional<PickLayer>& in_front,
                          const PickLayers& others) const;

 private:
  // Layers wait for the second poll, because they take all threads. By then the frame of the new
  // mesh is mostly drawn. A slider that moves in each frame begins none.
  static constexpr int kPollsBefore = 2;
  void make_layers();
  PickLayer balls() const;

  const Canvas& canvas_;
  const DrawnPicture& picture_;
  PickLayers mesh_layers_;  // of the mesh on screen; empty until they are made
  int polls_before_ = 0;    // until layers are made; 0: they are not due
  double margin_ = 0;       // BallPicker::margin() for the radii on screen
  Worker worker_;           // last member, so that its thread is joined first
};

}  // namespace alphascope
