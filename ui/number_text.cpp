// See the header.
#include "ui/number_text.hpp"

#include <cmath>
#include <cstdio>

namespace alphascope {

std::string number_text(double value, int decimals) {
  constexpr double kLongest = 1e9;  // beyond, digits are counted, not read
  char text[64];
  if (std::fabs(value) < kLongest) {
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
  } else {
    std::snprintf(text, sizeof text, "%.4g", value);
  }
  return text;
}

std::string short_number_text(double value, int decimals) {
  std::string text = number_text(value, decimals);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace alphascope
