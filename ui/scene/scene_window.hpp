// SPDX-License-Identifier: GPL-3.0-or-later
// The window that VTK draws into: framebuffers in the current OpenGL context.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace alphascope {

// Debian's VTK has the GLX build of GLEW. It reports an error for an EGL context although it has
// found every function. VTK would then regard the window as not set up, and look for all functions
// again before each picture. That takes longer than a small picture.
class SceneWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static SceneWindow* New();
  vtkTypeMacro(SceneWindow, vtkGenericOpenGLRenderWindow);
  SceneWindow(const SceneWindow&) = delete;
  void operator=(const SceneWindow&) = delete;

 protected:
  SceneWindow() = default;
  void OpenGLInitContext() override;
};

}  // namespace alphascope
