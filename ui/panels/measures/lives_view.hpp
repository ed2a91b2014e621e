// SPDX-License-Identifier: GPL-3.0-or-later
// The lives of cavities: the longest as bars against alpha, one below the other.
#pragma once

namespace alphascope {

struct PanelContext;
struct ShownLives;

// Draws the bars in the remaining room of the page. A click on a bar chooses its cavity and goes to
// an alpha at which it exists. A drag, or a click beside bars, sets alpha.
void draw_cavity_lives(PanelContext& ctx, ShownLives& memory);

}  // namespace alphascope
