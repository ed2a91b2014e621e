// VTK's renderer with a step after what is opaque, and one after what is translucent. For sources
// of the scene only.
#pragma once

#include <vtkOpenGLRenderer.h>

#include <functional>

namespace alphascope {

class SceneRenderer : public vtkOpenGLRenderer {
 public:
  static SceneRenderer* New();
  vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer);

  std::function<void()> after_opaque, after_translucent;  // empty: nothing

  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) override;
  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) override;

 protected:
  SceneRenderer() = default;
};

}  // namespace alphascope
