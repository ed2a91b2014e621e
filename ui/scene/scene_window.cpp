// SPDX-License-Identifier: GPL-3.0-or-later
// Initialises the window although GLEW complains about the context.
#include "ui/scene/scene_window.hpp"

#include <vtkObjectFactory.h>

namespace alphascope {

vtkStandardNewMacro(SceneWindow);

void SceneWindow::OpenGLInitContext() {
  Superclass::OpenGLInitContext();
  Initialized = GlewInitValid = true;
}

}  // namespace alphascope
