// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's renderer with a step of ours after the opaque things, and one after the translucent things.
// It can also draw translucent things quickly. For sources of the scene only.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>

#include <array>
#include <functional>

#include "ui/scene/gl/translucent_sum.hpp"

namespace alphascope {

class SceneRenderer : public vtkOpenGLRenderer {
 public:
  static SceneRenderer* New();
  vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer);

  std::function<void()> after_opaque, after_translucent;  // empty: no step

  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) override;
  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  SceneRenderer() = default;

 private:
  void peel_anew_when_resized();

  std::array<int, 2> peeled_size_{};
  vtkNew<TranslucentSum> translucent_sum_;  // used when depths are not peeled
};

}  // namespace alphascope
