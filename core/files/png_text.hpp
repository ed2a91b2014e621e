// SPDX-License-Identifier: GPL-3.0-or-later
// Texts and resolution inside a PNG picture, which image programs show among its properties.
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

// The picture with its resolution in dots per inch, as a chunk of pixels per metre (PNG
// specification, pHYs). Replaces none that is there. Throws as above.
std::string with_png_resolution(std::string_view png, int dpi);

}  // namespace alphascope
