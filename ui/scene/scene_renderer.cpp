// SPDX-License-Identifier: GPL-3.0-or-later
// Renders opaque things, then translucent ones, by VTK's peeling or by TranslucentSum.
#include "ui/scene/scene_renderer.hpp"

#include <vtkDepthPeelingPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderState.h>

#include <utility>

namespace alphascope {

vtkStandardNewMacro(SceneRenderer);

void SceneRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  Superclass::DeviceRenderOpaqueGeometry(target);
  if (after_opaque) after_opaque();
}

void SceneRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) {
  if (this->UseDepthPeeling) {
    peel_anew_when_resized();
    Superclass::DeviceRenderTranslucentPolygonalGeometry(target);
  } else {
    this->LastRenderingUsedDepthPeeling = 0;  // or actors would write depths
    vtkRenderState state(this);
    state.SetPropArrayAndCount(this->PropArray, this->PropArrayCount);
    translucent_sum_->Render(&state);
  }
  if (after_translucent) after_translucent();
}

// VTK 9.1's peeling keeps its framebuffer. After a change of size, textures of the old size stay
// attached to it for a while. OpenGL draws no farther than the smallest texture, so the pass is
// made anew.
void SceneRenderer::peel_anew_when_resized() {
  int width, height, x, y;
  this->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (std::exchange(peeled_size_, {width, height}) == std::array{width, height}) return;
  if (this->DepthPeelingPass == nullptr) return;
  this->DepthPeelingPass->ReleaseGraphicsResources(this->RenderWindow);
  this->DepthPeelingPass->Delete();
  this->DepthPeelingPass = nullptr;  // VTK makes another
}

void SceneRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  translucent_sum_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace alphascope
