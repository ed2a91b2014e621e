// Round distances between the numbers on an axis or a legend.
#pragma once

#include <algorithm>
#include <cmath>

namespace alphascope {

// The distance is 1, 2 or 5 times a power of ten. About `most` of them cover `span`.
inline double nice_step(double span, int most) {
  const double rough = span / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(std::max(rough, 1e-300))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace alphascope
