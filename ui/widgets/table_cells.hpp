// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of tables of numbers, for all panels.
#pragma once

#include <string>

namespace alphascope {

struct PanelContext;

// Width of a column's title in pixels, with the arrow of the sorted column.
float title_width(const char* title);
// Writes text at the right of the present cell.
void right_text(const std::string& text);
// A quiet button as high as a line of text, for rows that react to clicks themselves. `width` is in
// pixels at scale 1.
bool row_button(PanelContext& ctx, const char* name, const char* label, float width);
// Goes to the next cell and writes text at its right.
void number_cell(const std::string& text);

}  // namespace alphascope
