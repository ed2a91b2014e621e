// Numbers that are printed with a fixed number of decimals.
#pragma once

#include <cmath>

namespace alphascope {

// 0 where so many decimals would say "-0.000".
inline double without_minus_zero(double number, int decimals) {
  return std::fabs(number) * std::pow(10, decimals) <= 0.5 ? 0 : number;
}

}  // namespace alphascope
