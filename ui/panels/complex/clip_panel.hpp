// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the clip's panel, its commands and its handle in the picture share.
#pragma once

#include <array>

#include "core/document/settings/clip.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Sets the kind of cut. The first cut goes through the middle of the drawn balls and faces the
// viewer.
void set_clip_kind(ViewState& state, Clip::Kind kind);
// Puts the cut through the middle of the drawn balls. The normal may have any length but 0.
void set_clip_across(ViewState& state, const std::array<double, 3>& normal);
// Returns the range of positions in which the cut meets the drawn balls, Å.
std::array<double, 2> clip_range(const ViewState& state);

// Lets the mouse move and turn the handle. Returns whether it holds the handle or could take it.
bool clip_handle_mouse(PanelContext& ctx, ImVec2 corner, bool view_hovered);
void draw_clip_handle(PanelContext& ctx);

}  // namespace alphascope
