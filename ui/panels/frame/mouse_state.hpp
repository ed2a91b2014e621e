// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse in the window between frames. Plain data.
#pragma once

#include <cstdint>

namespace alphascope {

enum class HandlePart : std::uint8_t;  // ui/clip_handle.hpp

struct MouseState {
  double still_seconds = 0;  // since the mouse moved or a button was down
  float x = 0, y = 0;        // pixels, in the last frame
  bool dragging_view = false;
  // Parts of the clip's handle: held by the mouse, and under it or held. Zero: none.
  HandlePart clip_part{}, clip_part_hovered{};
};

}  // namespace alphascope
