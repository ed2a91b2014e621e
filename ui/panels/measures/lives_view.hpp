// From which alpha to which each cavity is there: the longest lives as bars, one below the other.
#pragma once

#include "ui/panels/measures/curve_memory.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// In all room that is left of the page. A click on a bar chooses its cavity, and goes to an alpha
// at which it is there; a drag or a click beside bars sets alpha.
void draw_cavity_lives(PanelContext& ctx, CurveMemory::Lives& memory);

}  // namespace alphascope
