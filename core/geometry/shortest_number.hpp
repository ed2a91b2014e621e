// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with the fewest digits that read as the same number. They are for programs that read
// them, and for people who type them again.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

class Alpha;

// "1.4", "-0.5", "100000", "0.0001", "1e+24": with an exponent only where that is easier to read.
inline std::string shortest_number(double number) {
  char text[48];
  char* const end = text + sizeof text;
  if (number == 0) return "0";  // for either sign
  const double size = std::fabs(number);
  const bool plain = size >= 1e-6 && size < 1e15;
  return {text, plain ? std::to_chars(text, end, number, std::chars_format::fixed).ptr
                      : std::to_chars(text, end, number).ptr};
}

// All digits, or the shortest decimal of the nearest double if that is the same number.
inline std::string shortest_number(const Alpha& alpha) {
  return alpha.is_shortest_of_double() ? shortest_number(alpha.nearest()) : alpha.digits();
}
inline std::string shortest_number(const LatticeAlpha& alpha) {
  return alpha.is_shortest_of_double() ? shortest_number(alpha.nearest()) : alpha.text();
}

}  // namespace alphascope
