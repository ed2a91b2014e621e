// SPDX-License-Identifier: GPL-3.0-or-later
// The program's icon in the sizes that window managers use, as part of the program.
#pragma once

#include <vector>

namespace alphascope {

struct IconPicture {
  int width = 0, height = 0;        // pixels
  std::vector<unsigned char> rgba;  // rows from the top, four bytes a pixel
};

std::vector<IconPicture> window_icon();

}  // namespace alphascope
