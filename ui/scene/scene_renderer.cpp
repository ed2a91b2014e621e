// See the header.
#include "ui/scene/scene_renderer.hpp"

#include <vtkObjectFactory.h>

namespace alphascope {

vtkStandardNewMacro(SceneRenderer);

void SceneRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  Superclass::DeviceRenderOpaqueGeometry(target);
  if (after_opaque) after_opaque();
}

void SceneRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) {
  Superclass::DeviceRenderTranslucentPolygonalGeometry(target);
  if (after_translucent) after_translucent();
}

}  // namespace alphascope
