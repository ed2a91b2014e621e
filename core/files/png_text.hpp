// SPDX-License-Identifier: GPL-3.0-or-later
// Texts inside a PNG picture, which image programs show among its properties.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alphascope {

// The picture with one text chunk per entry: keyword (1 to 79 printable ASCII characters) and UTF-8
// text. ASCII text goes into a plain chunk (PNG specification, tEXt), other text into an
// international one (iTXt), which fewer programs show. Throws std::invalid_argument if `png` is no
// PNG.
std::string with_png_text(std::string_view png,
                          const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace alphascope
