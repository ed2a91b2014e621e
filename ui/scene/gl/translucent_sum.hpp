// What is translucent, while something moves: the layers of a pixel are summed in any order, and
// what is seen is their mean. For sources of the scene only.
#pragma once

#include <vtkOpenGLRenderPass.h>

#include <string>

#include "ui/scene/gl/screen_quad.hpp"

namespace alphascope {

// As VTK's own pass for this, which draws to a second texture: with many layers a pixel, blending
// takes most of the time. The one texture here gets w * (r, g, b, 1) of each layer, w = -ln(1 -
// opacity). The sum of w tells both what the colours are divided by and how much the background
// shines through, exp(-sum). For layers of one opacity the picture is VTK's. L. Bavoil, K. Myers,
// Order independent transparency with dual depth peeling, NVIDIA, 2008 (weighted average).
class TranslucentSum : public vtkOpenGLRenderPass {
 public:
  static TranslucentSum* New();
  vtkTypeMacro(TranslucentSum, vtkOpenGLRenderPass);

  // Of the state's props, over what its renderer's window has drawn.
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
