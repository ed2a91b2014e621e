// SPDX-License-Identifier: GPL-3.0-or-later
// Reads version and extensions of the current OpenGL context.
#include "ui/scene/gl/opengl_feature.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

namespace alphascope {

bool has_opengl(int major, int minor, std::string_view extension) {
  GLint own_major = 0, own_minor = 0, extensions = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &own_major);
  glGetIntegerv(GL_MINOR_VERSION, &own_minor);
  if (own_major > major || (own_major == major && own_minor >= minor)) return true;
  glGetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint n = 0; n < extensions; ++n) {
    const GLubyte* const name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(n));
    if (name != nullptr && reinterpret_cast<const char*>(name) == extension) return true;
  }
  return false;
}

}  // namespace alphascope
