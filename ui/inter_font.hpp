// The letters of window and pictures, inside of the program: it looks the same everywhere, and
// nobody has to install a font that knows α. Inter, SIL Open Font License 1.1 (resources/fonts).
#pragma once

#include <span>

namespace alphascope {

// OpenType files.
std::span<const unsigned char> inter_regular();
std::span<const unsigned char> inter_semibold();

}  // namespace alphascope
