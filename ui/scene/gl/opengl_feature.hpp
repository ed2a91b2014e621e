// SPDX-License-Identifier: GPL-3.0-or-later
// Tests for features of the current OpenGL context beyond OpenGL 3.2. No VTK.
#pragma once

#include <string_view>

namespace alphascope {

// Whether OpenGL has at least this version or this extension ("GL_ARB_..."). Some drivers report
// just the version that was requested, although they have all functions of a newer one.
bool has_opengl(int major, int minor, std::string_view extension);

}  // namespace alphascope
