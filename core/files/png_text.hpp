// Texts inside a PNG picture, where image programs show them as its properties.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alphascope {

// The picture with one text chunk per entry: keyword (1 to 79 printable ASCII characters) and UTF-8
// text. What is all ASCII goes into a plain chunk (PNG specification, tEXt), which more programs
// show than the international one (iTXt) of the others. Throws std::invalid_argument when `png` is
// no PNG.
std::string with_png_text(std::string_view png,
                          const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace alphascope
