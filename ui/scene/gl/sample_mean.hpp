// SPDX-License-Identifier: GPL-3.0-or-later
// The mean of several samples of one picture, each shifted by a part of a pixel. For sources of the
// scene only.
#pragma once

#include "ui/scene/gl/screen_quad.hpp"

namespace alphascope {

class SampleMean {
 public:
  int count() const { return count_; }
  void forget() { count_ = 0; }
  bool is_of(int width, int height) const { return width == width_ && height == height_; }
  // Adds the picture that the window shows, which has this size (pixels).
  void add(vtkOpenGLRenderWindow* window, int width, int height);
  // Framebuffer with the mean of all added samples. Its colours are multiplied by alpha.
  vtkOpenGLFramebufferObject* resolve(vtkOpenGLRenderWindow* window);
  vtkTextureObject* picture() { return picture_.texture(); }  // of the last resolve()
  void release(vtkWindow* window);

 private:
  void draw(vtkOpenGLRenderWindow* window, vtkTextureObject* from, float scale);

  int count_ = 0, width_ = 0, height_ = 0;
  DrawnTexture sum_, picture_;
  QuadProgram program_;
};

}  // namespace alphascope
