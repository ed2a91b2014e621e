// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of samples in a pixel.
#pragma once

#include <array>

namespace alphascope {

// Position of sample `k`: pixels to the right and up from the pixel's middle, each from -0.5 to
// 0.5. The first 4, 8 and 16 samples are spread evenly.
std::array<double, 2> sample_place(int k);

}  // namespace alphascope
