// SPDX-License-Identifier: GPL-3.0-or-later
// The scene with the size of its picture in the window. It notes whether the picture must be drawn
// again.
#pragma once

#include <utility>

#include "ui/scene/scene.hpp"

namespace alphascope {

class Canvas {
 public:
  const Scene& scene() const { return scene_; }
  // The scene for a change that needs a new picture.
  Scene& change() {
    changed_ = true;
    return scene_;
  }
  // The scene for drawing, and for changes after which this class need not ask for a new picture.
  Scene& drawing() { return scene_; }
  bool changed() const { return changed_; }
  bool take_change() { return std::exchange(changed_, false); }

  // Pixels of the picture; 0 before the first one.
  int width() const { return width_; }
  int height() const { return height_; }
  static bool is_large_enough(int width, int height) { return width >= 8 && height >= 8; }
  void resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    changed_ = true;
  }

  // The style without regard to leave_out_balls().
  const SceneStyle& style() const { return style_; }
  void set_style(const SceneStyle& style) {
    style_ = style;
    send_style();
  }
  // Leaves out balls of the style, because drawing them takes too long.
  void leave_out_balls(bool left_out) {
    if (std::exchange(without_balls_, left_out) != left_out) send_style();
  }
  bool without_balls() const { return without_balls_; }

 private:
  void send_style() {
    SceneStyle sent = style_;
    if (without_balls_) sent.balls = false;
    scene_.set_style(sent);
  }

  Scene scene_;
  SceneStyle style_;
  bool without_balls_ = false;
  bool changed_ = true;
  int width_ = 0, height_ = 0;
};

}  // namespace alphascope
