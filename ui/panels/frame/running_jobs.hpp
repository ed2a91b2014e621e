// SPDX-License-Identifier: GPL-3.0-or-later
// The jobs that run beside the window, listed over the picture.
#pragma once

#include "ui/panels/frame/overlay.hpp"

namespace alphascope {

// `corner`: the top right of the list, pixels of the screen.
void draw_running_jobs(PanelContext& ctx, ImVec2 corner);

}  // namespace alphascope
