// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text with a fixed number of decimals.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace alphascope {

// Like "%.3f", but "0.000" instead of "-0.000".
inline std::string fixed_digits(double number, int decimals) {
  char text[400];  // the largest double has 309 digits
  std::snprintf(text, sizeof text, "%.*f", decimals, number);
  const std::string_view digits(text);
  const bool minus_zero =
      digits.starts_with('-') && digits.find_first_not_of("0.", 1) == digits.npos;
  return std::string(digits.substr(minus_zero ? 1 : 0));
}

}  // namespace alphascope
