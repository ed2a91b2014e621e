// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the display panel that choose colours.
#pragma once

#include <string>

#include "core/document/settings/paint.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct PanelContext;

struct PaintRows {
  std::string name;  // beginning of the widgets' names: "display.ball"
  PaintTarget what = PaintTarget::balls;
  // Range of the colours in the picture; none: colours show no quantity.
  std::optional<ColourRange> drawn;
  Rgb8 usual;  // the colour used if there is one colour and the user has chosen none
};

// Draws three rows: the scheme, its map or its one colour, and the range. Rows that do not apply
// are greyed, not hidden, so that nothing below moves.
void paint_rows(PanelContext& ctx, const PaintRows& rows, Paint& paint);

}  // namespace alphascope
