// SPDX-License-Identifier: GPL-3.0-or-later
// Ambient occlusion on two scales, shadows, fading with depth, and outlines. They are applied to
// the picture after VTK has drawn its opaque things, and before translucent ones. A second step
// applies them to the fronts of translucent things. All inputs are colours and depths, so that
// balls, faces, lines, cuts and both kinds of camera work alike. For sources of the scene only.
#pragma once

#include <vtkOpenGLRenderer.h>

#include <array>

#include "ui/scene/gl/screen_quad.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct FinishSettings {
  int occlusion_taps = 0;                     // on each scale; 0: no occlusion
  float occlusion_strength = 1;               // 0 to 1
  float near_radius = 5.5f, far_radius = 15;  // reach of both scales of occlusion, Å
  std::array<float, 3> light{0, 0, 1};        // towards the light that casts shadows
  float shadow_reach = 30;                    // length of a shadow ray, Å
  int turn = 0;                               // number of the sample, which turns the pattern
  float depth_cue = 0;                        // share of the background colour at the greatest
                                              // depth, 0 to 1
  float outline_width = 0;                    // pixels; 0: none
  float outline_jump = 1;                     // least jump in depth with an outline, Å
  Colour background;
  bool transparent = false;  // no background; distant things become transparent instead of fading
                             // to it
  Colour line;               // colour of outlines
  // Opacity of the most opaque translucent things, whose fronts are finished; 0: none.
  float translucent_opacity = 0;
  bool any() const { return occlusion_taps > 0 || depth_cue > 0 || outline_width > 0; }
};

class FinishPass {
 public:
  // Applies the steps to the picture that `renderer` has just drawn into its window's framebuffer.
  void apply(vtkOpenGLRenderer* renderer, const FinishSettings& finish);
  // Applies them to fronts of translucent things, after those were drawn exactly over the same
  // picture.
  void apply_to_translucent(vtkOpenGLRenderer* renderer, const FinishSettings& finish);
  void release(vtkWindow* window);

 private:
  void give(vtkOpenGLRenderer* renderer, const FinishSettings& finish, vtkShaderProgram* program);
  void draw_fronts(vtkOpenGLRenderer* renderer, const FinishSettings& finish, int width,
                   int height);
  void pass(vtkOpenGLRenderer* renderer, const FinishSettings& finish, bool translucent);

  DrawnTexture result_;
  DrawnDepths fronts_;  // of translucent things
  // Index: + 1 with occlusion, + 2 for translucent fronts. They are separate programs because
  // software OpenGL computes both sides of a condition.
  QuadProgram programs_[4];
};

}  // namespace alphascope
