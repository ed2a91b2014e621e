// What the current OpenGL context can do beyond OpenGL 3.2. No VTK.
#pragma once

#include <string_view>

namespace alphascope {

// Of this version, or with this extension, "GL_ARB_...": some drivers give no newer version than
// was asked for, and have all of its functions.
bool has_opengl(int major, int minor, std::string_view extension);

}  // namespace alphascope
