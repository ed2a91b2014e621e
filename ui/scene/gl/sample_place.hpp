// Where in a pixel each of its samples lies.
#pragma once

#include <array>

namespace alphascope {

// Of sample `k` of a pixel: pixels to the right and up from its middle, each within a half. The
// first 4, 8 and 16 are spread evenly.
std::array<double, 2> sample_place(int k);

}  // namespace alphascope
