// SPDX-License-Identifier: GPL-3.0-or-later
// Parses and rounds exact decimal numbers.
#include "core/read/decimal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alphascope {
namespace {

constexpr std::int64_t kSaturated = std::int64_t{1} << 62;
constexpr int kMostDigits = 18;  // 10^18 < 2^63
constexpr int kExponentBound = 100000;

constexpr std::int64_t kPowers[kMostDigits + 1] = {1,
                                                   10,
                                                   100,
                                                   1000,
                                                   10000,
                                                   100000,
                                                   1000000,
                                                   10000000,
                                                   100000000,
                                                   1000000000,
                                                   10000000000,
                                                   100000000000,
                                                   1000000000000,
                                                   10000000000000,
                                                   100000000000000,
                                                   1000000000000000,
                                                   10000000000000000,
                                                   100000000000000000,
                                                   1000000000000000000};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_word(std::string_view text, std::string_view word) {
  return text.size() == word.size() && std::equal(text.begin(), text.end(), word.begin(),
                                                  [](char a, char b) { return (a | 0x20) == b; });
}

bool names_no_finite_number(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return is_word(text, "nan") || is_word(text, "inf") || is_word(text, "infinity") ||
         is_word(text, "-nan(ind)") || is_word(text, "1.#qnan") || is_word(text, "1.#inf");
}

struct Mantissa {
  std::int64_t value = 0;
  int significant = 0;  // digits in value
  int dropped = 0;      // digits after the significant ones
  bool sticky = false;  // some dropped digit was not 0

  void push(char c) {
    if (significant < kMostDigits) {
      value = value * 10 + (c - '0');
      significant += value != 0;
    } else {
      ++dropped;
      sticky |= c != '0';
    }
  }
};

}  // namespace

double Decimal::to_double() const {
  // Parsing calls this several times per atom. pow() would take a tenth of the time of reading.
  if (digits >= 0 && digits <= kMostDigits) {
    return static_cast<double>(mantissa) / static_cast<double>(kPowers[digits]);
  }
  return static_cast<double>(mantissa) * std::pow(10.0, -digits);
}

DecimalStatus parse_decimal(std::string_view text, Decimal& result) {
  const char* p = text.data();
  const char* const end = p + text.size();
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  Mantissa mantissa;
  const char* const integral = p;
  for (; p != end && is_digit(*p); ++p) mantissa.push(*p);
  std::ptrdiff_t seen = p - integral;
  std::ptrdiff_t places = 0;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    for (; p != end && is_digit(*p); ++p) mantissa.push(*p);
    places = p - fraction;
    seen += places;
  }
  std::int64_t exponent = 0;
  if (seen > 0 && p != end && (*p == 'e' || *p == 'E' || *p == 'd' || *p == 'D')) {
    ++p;
    const bool minus = p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    if (p == end) return DecimalStatus::malformed;
    for (; p != end && is_digit(*p); ++p) {
      exponent = std::min<std::int64_t>(exponent * 10 + (*p - '0'), kExponentBound);
    }
    if (minus) exponent = -exponent;
  }
  if (p != end || seen == 0) {
    return names_no_finite_number(text) ? DecimalStatus::not_finite : DecimalStatus::malformed;
  }
  if (mantissa.value == 0) {
    result = {};
    return DecimalStatus::ok;
  }
  std::int64_t digits = places - mantissa.dropped - exponent;
  // Marks a cut tail, so that a later rounding does not see a tie or an exact value.
  if (mantissa.sticky && mantissa.value % 5 == 0) ++mantissa.value;
  while (mantissa.value % 10 == 0) {
    mantissa.value /= 10;
    --digits;
  }
  result.mantissa = negative ? -mantissa.value : mantissa.value;
  result.digits = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(digits, -2 * kExponentBound, 2 * kExponentBound));
  return DecimalStatus::ok;
}

std::int64_t to_units(const Decimal& value, int digits, double& rounding) {
  rounding = 0;
  const int shift = digits - value.digits;
  if (shift >= 0) {
    if (value.mantissa == 0) return 0;
    if (shift > kMostDigits || std::llabs(value.mantissa) > kSaturated / kPowers[shift]) {
      return value.mantissa > 0 ? kSaturated : -kSaturated;
    }
    return value.mantissa * kPowers[shift];
  }
  const std::int64_t size = std::llabs(value.mantissa);
  if (-shift > kMostDigits) {
    rounding = static_cast<double>(size) * std::pow(10.0, shift);
    return 0;
  }
  const std::int64_t power = kPowers[-shift];
  const std::int64_t rest = size % power;
  const bool up = rest >= power - rest;
  rounding = static_cast<double>(up ? power - rest : rest) / static_cast<double>(power);
  const std::int64_t rounded = size / power + (up ? 1 : 0);
  return value.mantissa < 0 ? -rounded : rounded;
}

int printed_decimals(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return 0;
  std::size_t end = point + 1;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  return static_cast<int>(std::min<std::size_t>(end - point - 1, 18));
}

const char* remedy_of_number(DecimalStatus status, const char* malformed) {
  return status == DecimalStatus::not_finite
             ? "Coordinates must be finite; remove this atom or compute it again"
             : malformed;
}

}  // namespace alphascope
