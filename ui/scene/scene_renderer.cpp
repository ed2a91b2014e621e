// See the header.
#include "ui/scene/scene_renderer.hpp"

#include <vtkObjectFactory.h>
#include <vtkRenderState.h>

namespace alphascope {

vtkStandardNewMacro(SceneRenderer);

void SceneRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  Superclass::DeviceRenderOpaqueGeometry(target);
  if (after_opaque) after_opaque();
}

void SceneRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) {
  if (this->UseDepthPeeling) {
    Superclass::DeviceRenderTranslucentPolygonalGeometry(target);
  } else {
    this->LastRenderingUsedDepthPeeling = 0;  // or actors would write depths
    vtkRenderState state(this);
    state.SetPropArrayAndCount(this->PropArray, this->PropArrayCount);
    translucent_sum_->Render(&state);
  }
  if (after_translucent) after_translucent();
}

void SceneRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  translucent_sum_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace alphascope
