// Cells of tables of numbers.
#pragma once

#include <string>

namespace alphascope {

std::string measure_text(double value);  // Å³ or Å²: "12,345.67"

// At the right of the present cell.
void right_text(const std::string& text);
// The next cell, its text at the right.
void number_cell(const std::string& text);

}  // namespace alphascope
