// SPDX-License-Identifier: GPL-3.0-or-later
// Quick transparency for moving pictures. The layers of a pixel are summed in any order, and their
// mean is drawn. For sources of the scene only.
#pragma once

#include <vtkOpenGLRenderPass.h>

#include <string>

#include "ui/scene/gl/screen_quad.hpp"

namespace alphascope {

// VTK's own pass draws into two textures, and with many layers blending takes most of the time.
// This pass has one texture, to which each layer adds w * (r, g, b, 1), where w = -ln(1 - opacity).
// The sum of w divides the colours, and exp(-sum) is the share of the background. If all layers
// have the same opacity, the picture equals VTK's. L. Bavoil, K. Myers, Order independent
// transparency with dual depth peeling, NVIDIA, 2008 (weighted average).
class TranslucentSum : public vtkOpenGLRenderPass {
 public:
  static TranslucentSum* New();
  vtkTypeMacro(TranslucentSum, vtkOpenGLRenderPass);

  // Draws the translucent props of `state` over the picture in its renderer's window.
  void Render(const vtkRenderState* state) override;
  bool PostReplaceShaderValues(std::string& vertex_shader, std::string& geometry_shader,
                               std::string& fragment_shader, vtkAbstractMapper* mapper,
                               vtkProp* prop) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  TranslucentSum() = default;
  ~TranslucentSum() override = default;

 private:
  TranslucentSum(const TranslucentSum&) = delete;
  void operator=(const TranslucentSum&) = delete;

  void sum(const vtkRenderState* state, vtkTextureObject* depths, int width, int height);
  void show(vtkOpenGLRenderWindow* window, int width, int height);

  DrawnTexture sums_;
  QuadProgram mean_;
};

}  // namespace alphascope
