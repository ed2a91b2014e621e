// SPDX-License-Identifier: GPL-3.0-or-later
// Words for a cavity: its kind, and a title for the mouse.
#include <string>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/tables/cell_value.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {

const char* kind_word(const CavityLine& line) {
  if (line.is_void) return "void";
  if (line.is_network) return "network";
  return line.is_part ? "part" : "pocket";
}

std::string cavity_title(const CavityPage& page, std::size_t row) {
  const CavityLine& line = page.rows.lines->of[row];
  return "Cavity " + with_separators(static_cast<long long>(row) + 1) + "  ·  " + kind_word(line) +
         "  ·  " + measure_text(line.volume_sa_angstrom3) + " Å³";
}

}  // namespace alphascope
