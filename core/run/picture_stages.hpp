// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a picture of a complex. They follow the stages of the engine.
#pragma once

#include <string_view>

namespace alphascope::stage {

// Making the arrays for drawing, with the work that a device does for them.
inline constexpr std::string_view kMesh = "mesh";
inline constexpr std::string_view kUpload = "upload";  // transfer of the arrays to OpenGL
inline constexpr std::string_view kDraw = "draw";      // the rest of the first frame with them

}  // namespace alphascope::stage
