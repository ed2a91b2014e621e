// What is done to a picture of opaque bodies after VTK has drawn it and before anything translucent
// comes: ambient occlusion on two scales, a fade to the background with depth, silhouettes. And
// then the same to the fronts of what is translucent. All from colours and depths, so that it fits
// balls, faces, lines, cuts and both kinds of camera. For sources of the scene only.
#pragma once

#include <vtkOpenGLRenderer.h>

#include <array>

#include "ui/scene/gl/screen_quad.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct Finish {
  int occlusion_taps = 0;                     // of each scale; 0: no occlusion
  float occlusion_strength = 1;               // 0 to 1
  float near_radius = 5.5f, far_radius = 15;  // of what occludes, Å
  std::array<float, 3> light{0, 0, 1};        // towards the light that casts shadows
  float shadow_reach = 30;                    // of a shadow, Å
  int turn = 0;                               // of the pattern: the number of the sample
  float depth_cue = 0;                        // share of background in the farthest, 0 to 1
  float silhouette_width = 0;                 // pixels; 0: none
  float silhouette_jump = 1;                  // Å of depth that a silhouette marks, at least
  Colour background;
  bool transparent = false;  // there is none, and what is far away becomes transparent instead
  Colour line;               // of silhouettes
  // Of what is translucent and the most opaque, whose fronts are finished; 0: none are.
  float translucent_opacity = 0;
  bool any() const { return occlusion_taps > 0 || depth_cue > 0 || silhouette_width > 0; }
};

class FinishPass {
 public:
  // Of what the window of `renderer` has just drawn into its framebuffer.
  void apply(vtkOpenGLRenderer* renderer, const Finish& finish);
  // Of the same, when what is translucent has been drawn over it, exactly.
  void apply_to_translucent(vtkOpenGLRenderer* renderer, const Finish& finish);
  void release(vtkWindow* window);

 private:
  void give(vtkOpenGLRenderer* renderer, const Finish& finish, vtkShaderProgram* program);
  void draw_fronts(vtkOpenGLRenderer* renderer, const Finish& finish, int width, int height);
  void pass(vtkOpenGLRenderer* renderer, const Finish& finish, bool translucent);

  DrawnTexture result_;
  DrawnDepths fronts_;  // of what is translucent
  // + 1: with occlusion, + 2: translucent. Software OpenGL computes also what a condition leaves
  // out.
  QuadProgram programs_[4];
};

}  // namespace alphascope
