// Fonts of window and pictures, as part of the program. So it looks the same everywhere, and needs
// no installed font with the letter α. Inter, SIL Open Font License 1.1 (resources/fonts).
#pragma once

#include <span>

namespace alphascope {

// Contents of OpenType files.
std::span<const unsigned char> inter_regular();
std::span<const unsigned char> inter_semibold();

}  // namespace alphascope
