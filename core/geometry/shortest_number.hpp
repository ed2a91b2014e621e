// Numbers with as few digits as give the same number when read again: for what programs read and
// for what people type again.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

// "1.4", "-0.5", "100000", "0.0001", "1e+24": the exponent only where it saves reading.
inline std::string shortest_number(double number) {
  char text[48];
  char* const end = text + sizeof text;
  if (number == 0) return "0";  // whatever its sign
  const double size = std::fabs(number);
  const bool plain = size >= 1e-6 && size < 1e15;
  return {text, plain ? std::to_chars(text, end, number, std::chars_format::fixed).ptr
                      : std::to_chars(text, end, number).ptr};
}

// All its digits; where a double says the same, as that.
inline std::string shortest_number(const Alpha& alpha) {
  return alpha.is_shortest_of_double() ? shortest_number(alpha.nearest()) : alpha.digits();
}
inline std::string shortest_number(const LatticeAlpha& alpha) {
  return alpha.is_shortest_of_double() ? shortest_number(alpha.nearest()) : alpha.text();
}

}  // namespace alphascope
