// SPDX-License-Identifier: GPL-3.0-or-later
// A small window over the picture, for notes and progress.
#pragma once

#include <imgui.h>

namespace alphascope {

struct PanelContext;

// `position` of the point `pivot` of the window, in pixels of the screen; {1, 0} is its top right.
void begin_overlay(PanelContext& ctx, const char* id, ImVec2 position, ImVec2 pivot);
void end_overlay();

}  // namespace alphascope
