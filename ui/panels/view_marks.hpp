// Scale bar and legends over the 3-D view.
#pragma once

#include "ui/panels/widgets.hpp"

namespace alphascope {

// `corner` and `size` of the view, pixels. Returns how high the legends are, from its bottom.
float draw_view_marks(PanelContext& ctx, ImVec2 corner, ImVec2 size);

}  // namespace alphascope
