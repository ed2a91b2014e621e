// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers with a fixed number of decimals, shortens them, and replaces minus signs.
#include "ui/number_text.hpp"

#include <cmath>
#include <cstdio>

#include "core/chart/readable_number.hpp"
#include "core/text/fixed_digits.hpp"

namespace alphascope {

std::string number_text(double value, int decimals) {
  constexpr double kLongest = 1e9;  // larger numbers get a power of ten
  if (std::fabs(value) < kLongest) return readable_number(fixed_digits(value, decimals));
  char text[64];
  std::snprintf(text, sizeof text, "%.4g", value);
  return readable_number(text);
}

std::string short_number_text(double value, int decimals) {
  std::string text = number_text(value, decimals);
  const bool plain =
      text.find_first_not_of("0123456789.", text.starts_with("−") ? 3 : 0) == std::string::npos;
  if (text.find('.') == std::string::npos || !plain) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string with_minus_signs(const std::string& sentence) {
  const auto is_digit = [&](std::size_t at) {
    return at < sentence.size() && sentence[at] >= '0' && sentence[at] <= '9';
  };
  std::string text;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool starts = i == 0 || sentence[i - 1] == ' ' || sentence[i - 1] == '(';
    if (sentence[i] == '-' && starts && is_digit(i + 1)) {
      text += "−";
    } else {
      text += sentence[i];
    }
  }
  return text;
}

}  // namespace alphascope
