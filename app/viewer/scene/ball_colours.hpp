// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the balls on screen. Colours that depend on the complex come with its drawing, so
// no picture mixes two alphas. If only the paint changes, a worker makes the colours, and the last
// colours and their legend stay until these are ready.
#pragma once

#include <functional>
#include <utility>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/run/worker.hpp"

namespace alphascope {

class BallColours {
 public:
  // `wake` as in Worker.
  BallColours(std::function<void()> wake, Canvas& canvas, DrawnPicture& picture)
      : canvas_(canvas), picture_(picture), worker_(std::move(wake)) {}

  // Makes the colours of this paint.
  void make(const Paint& paint);
  // Shows the colours of the picture's painting.
  void show();
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }

 private:
  Canvas& canvas_;
  DrawnPicture& picture_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
