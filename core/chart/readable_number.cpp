// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers for people.
#include "core/chart/readable_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

constexpr const char* kMinus = "−";

std::string power_of_ten(int exponent) {
  static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

std::string without_zeros(std::string decimals) {
  if (decimals.find('.') == std::string::npos) return decimals;
  while (decimals.back() == '0') decimals.pop_back();
  if (decimals.back() == '.') decimals.pop_back();
  return decimals;
}

}  // namespace

std::string readable_number(const std::string& printed) {
  const bool negative = printed.starts_with('-');
  std::string digits = printed.substr(negative ? 1 : 0);
  if (const std::size_t e = digits.find_first_of("eE"); e != std::string::npos) {
    const std::string power =
        power_of_ten(static_cast<int>(std::strtol(&digits[e + 1], nullptr, 10)));
    const std::string factor = without_zeros(digits.substr(0, e));
    digits = factor == "1" ? power : factor + "·" + power;
  }
  return (negative ? kMinus : "") + digits;
}

std::string separated_number(const std::string& printed) {
  const bool negative = printed.starts_with('-');
  const std::size_t first = negative ? 1 : 0;
  const std::size_t end = std::min(printed.find_first_not_of("0123456789", first), printed.size());
  return readable_number(printed.substr(0, first) +
                         grouped_digits(printed.substr(first, end - first)) + printed.substr(end));
}

std::string chart_number(double value) {
  char text[64];
  const double size = std::fabs(value);
  if (size != 0 && (size >= 1e9 || size < 1e-4)) {
    std::snprintf(text, sizeof text, "%.2e", value);
    return readable_number(text);
  }
  const int decimals =
      size == 0 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return separated_number(without_zeros(text));
}

}  // namespace alphascope
