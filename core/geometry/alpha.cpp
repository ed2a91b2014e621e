// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing alpha as a decimal, without rounding.
#include "core/geometry/alpha.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace alphascope {
namespace {

constexpr int kMostWholeDigits = 37;  // below 2^127
constexpr int kExponentBound = 100000;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string text_of(double value) {
  char text[48];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

double nearest_to(const std::string& digits) {
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

// A decimal number as its text has it: digits, of which `places` are behind the point.
struct Written {
  std::string digits;
  std::int64_t places = 0;
  bool negative = false;
};

bool split(std::string_view text, Written& written) {
  const char* p = text.data();
  const char* const end = p + text.size();
  written.negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  bool point = false;
  for (; p != end && (is_digit(*p) || (*p == '.' && !point)); ++p) {
    point = point || *p == '.';
    if (*p != '.') written.digits += *p;
    if (*p != '.' && point) ++written.places;
  }
  if (written.digits.empty()) return false;
  if (p != end && (*p == 'e' || *p == 'E')) {
    const bool minus = ++p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    if (p == end) return false;
    std::int64_t exponent = 0;
    for (; p != end && is_digit(*p); ++p) {
      exponent = std::min<std::int64_t>(exponent * 10 + (*p - '0'), kExponentBound);
    }
    written.places -= minus ? -exponent : exponent;
  }
  if (p != end) return false;
  // Drop zeros in front, and zeros at the end behind the point.
  written.digits.erase(0, std::min(written.digits.find_first_not_of('0'), written.digits.size()));
  while (written.places > 0 && !written.digits.empty() && written.digits.back() == '0') {
    written.digits.pop_back();
    --written.places;
  }
  return true;
}

}  // namespace

Alpha::Alpha(double angstrom2) {
  if (!is_valid_alpha(angstrom2)) {
    nearest_ = angstrom2;
    return;
  }
  if (read(text_of(angstrom2), *this) == Reading::too_fine) {
    char fixed[64];
    const auto end = std::to_chars(fixed, fixed + sizeof fixed, angstrom2, std::chars_format::fixed,
                                   kMostDigits);
    read({fixed, end.ptr}, *this);
  }
}

Alpha::Reading Alpha::read(std::string_view text, Alpha& alpha) {
  Alpha read;
  const Reading reading = read_decimal(text, read.whole_, read.fraction_);
  if (reading != Reading::ok) return reading;
  // The value must be from -10^24 to 10^24.
  constexpr Int128 kMost = Int128{1000000000000} * 1000000000000;
  if (read.whole_ < -kMost || read.whole_ > kMost || (read.whole_ == kMost && read.fraction_ > 0)) {
    return Reading::too_large;
  }
  read.nearest_ = nearest_to(read.digits());
  alpha = read;
  return Reading::ok;
}

Alpha::Reading read_decimal(std::string_view text, Int128& whole, std::int64_t& fraction) {
  using Reading = Alpha::Reading;
  Written written;
  if (!split(text, written)) return Reading::malformed;
  whole = 0;
  fraction = 0;
  std::string& digits = written.digits;
  if (digits.empty()) return Reading::ok;
  const std::int64_t before_point = static_cast<std::int64_t>(digits.size()) - written.places;
  if (before_point > kMostWholeDigits) return Reading::too_large;
  if (written.places > Alpha::kMostDigits) return Reading::too_fine;
  digits.append(static_cast<std::size_t>(Alpha::kMostDigits - written.places), '0');
  for (std::size_t n = 0; n < digits.size(); ++n) {
    const int digit = digits[n] - '0';
    if (n + Alpha::kMostDigits >= digits.size()) {
      fraction = fraction * 10 + digit;
    } else {
      whole = whole * 10 + digit;
    }
  }
  if (!written.negative) return Reading::ok;
  whole = fraction > 0 ? -whole - 1 : -whole;
  if (fraction > 0) fraction = Alpha::kParts - fraction;
  return Reading::ok;
}

bool Alpha::is_decimal() const {
  return is_valid_alpha(nearest_);
}

std::string Alpha::digits() const {
  return is_decimal() ? decimal_text(whole_, fraction_) : text_of(nearest_);
}

std::string decimal_text(Int128 whole, std::int64_t fraction) {
  const bool negative = whole < 0;
  if (negative) whole = -whole;
  if (negative && fraction > 0) {
    --whole;
    fraction = Alpha::kParts - fraction;
  }
  std::string text;
  for (; whole > 0; whole /= 10) text += static_cast<char>('0' + static_cast<int>(whole % 10));
  if (text.empty()) text = "0";
  if (negative) text += '-';
  std::reverse(text.begin(), text.end());
  if (fraction == 0) return text;
  std::string behind = std::to_string(Alpha::kParts + fraction).substr(1);
  behind.erase(behind.find_last_not_of('0') + 1);
  return text + "." + behind;
}

std::partial_ordering operator<=>(const Alpha& a, const Alpha& b) {
  // A larger number never has a smaller nearest double. So where the nearest doubles differ, they
  // decide.
  if (const auto order = a.nearest_ <=> b.nearest_; order != 0) return order;
  if (const auto order = a.whole_ <=> b.whole_; order != 0) return order;
  return a.fraction_ <=> b.fraction_;
}

}  // namespace alphascope
