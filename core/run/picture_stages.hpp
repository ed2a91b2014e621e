// The stages of a picture of a complex, which follow those of its engine.
#pragma once

#include <string_view>

namespace alphascope::stage {

// Arrays of what is drawn, and what a device finds for them.
inline constexpr std::string_view kMesh = "mesh";
inline constexpr std::string_view kUpload = "upload";  // their way to OpenGL
inline constexpr std::string_view kDraw = "draw";      // the rest of the first frame with them

}  // namespace alphascope::stage
