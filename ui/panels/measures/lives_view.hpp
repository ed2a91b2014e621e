// SPDX-License-Identifier: GPL-3.0-or-later
// The lives of cavities: the longest as bars against alpha, one below the other.
#pragma once

#include "ui/panels/measures/curve_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Draws the bars in the remaining room of the page. A click on a bar chooses its cavity and goes to
// an alpha at which it exists. A drag, or a click beside bars, sets alpha.
void draw_cavity_lives(PanelContext& ctx, CurveState::Lives& memory);

}  // namespace alphascope
