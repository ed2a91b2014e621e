// The rows of the display panel that say what something is coloured by.
#pragma once

#include <string>

#include "core/document/settings/paint.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

struct PaintRows {
  std::string name;  // of the widgets: "display.ball"
  Painted what = Painted::balls;
  std::optional<ColourRange> drawn;  // of the colours in the picture; none: of no quantity
  Rgb8 usual;                        // where all is in one colour and none is chosen
};

// Scheme; map, or the one colour; range. Rows that do not apply stay, greyed: what is below must
// not move.
void paint_rows(PanelContext& ctx, const PaintRows& rows, Paint& paint);

}  // namespace alphascope
