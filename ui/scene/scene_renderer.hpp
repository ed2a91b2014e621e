// VTK's renderer with a step between what is opaque and what is translucent. For sources of the
// scene only.
#pragma once

#include <vtkOpenGLRenderer.h>

#include <functional>

namespace alphascope {

class SceneRenderer : public vtkOpenGLRenderer {
 public:
  static SceneRenderer* New();
  vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer);

  std::function<void()> after_opaque;  // empty: nothing

  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) override;

 protected:
  SceneRenderer() = default;
};

}  // namespace alphascope
