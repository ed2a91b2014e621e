// Cells of tables of numbers.
#pragma once

#include <string>

namespace alphascope {

struct PanelContext;

std::string measure_text(double value);  // Å³ or Å²: "12,345.67"

// Pixels that a column's title needs, with the arrow of the one that rows are sorted by.
float title_width(const char* title);
// At the right of the present cell.
void right_text(const std::string& text);
// A quiet button as high as a line of text, in a row that is itself clickable; width at scale 1.
bool row_button(PanelContext& ctx, const char* name, const char* label, float width);
// The next cell, its text at the right.
void number_cell(const std::string& text);

}  // namespace alphascope
