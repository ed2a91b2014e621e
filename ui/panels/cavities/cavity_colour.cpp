// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a cavity. It follows the number that the cavity keeps while alpha moves.
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/chart/colour_map.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {

Colour cavity_colour(const CavityPage& page, std::size_t row) {
  const CavityNumbers& numbers = *page.rows.lines->numbers;
  return to_colour(cavity_colour(numbers.of[page.rows.table().order[row]]));
}

}  // namespace alphascope
