// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the font files into the program.
#include "ui/inter_font.hpp"

#include "ui/embedded_file.hpp"

ALPHASCOPE_EMBEDDED_FILE(inter_regular, ALPHASCOPE_FONTS "/Inter-Regular.otf");
ALPHASCOPE_EMBEDDED_FILE(inter_semibold, ALPHASCOPE_FONTS "/Inter-SemiBold.otf");

namespace alphascope {

std::span<const unsigned char> inter_regular() {
  return {alphascope_inter_regular_begin, alphascope_inter_regular_end};
}

std::span<const unsigned char> inter_semibold() {
  return {alphascope_inter_semibold_begin, alphascope_inter_semibold_end};
}

}  // namespace alphascope
