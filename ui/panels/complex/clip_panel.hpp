// What the clip's panel, its commands and its handle in the picture share.
#pragma once

#include <array>

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// The first time, the cut goes through the middle of what is drawn and faces the viewer.
void set_clip_kind(ViewState& state, Clip::Kind kind);
// Through the middle of what is drawn, with this normal (of any length but 0).
void set_clip_across(ViewState& state, const std::array<double, 3>& normal);
// Positions between which the cut meets what is drawn, Å.
std::array<double, 2> clip_range(const ViewState& state);

// The mouse on the handle: true while it holds it, or is above it and may take it.
bool clip_handle_mouse(PanelContext& ctx, ImVec2 corner, bool view_hovered);
void draw_clip_handle(PanelContext& ctx);

}  // namespace alphascope
