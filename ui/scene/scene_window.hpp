// The window that VTK believes it draws into: its framebuffers in the current context.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace alphascope {

// Debian's VTK carries the GLX build of GLEW, which complains about an EGL context although it has
// found every function. VTK would then take the window for one that is not set up yet, and look for
// all of them again before each picture, which takes longer than a small picture.
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
