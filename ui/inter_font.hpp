// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts of window and pictures, which are part of the program. So all machines show the same
// letters, and none needs an installed font with α. The font is Inter, under the SIL Open Font
// License 1.1 (resources/fonts).
#pragma once

#include <span>

namespace alphascope {

// Contents of OpenType files.
std::span<const unsigned char> inter_regular();
std::span<const unsigned char> inter_semibold();

}  // namespace alphascope
