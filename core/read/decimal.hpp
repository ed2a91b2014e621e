// SPDX-License-Identifier: GPL-3.0-or-later
// Exact decimal numbers of text files. No binary floating point lies between file and lattice.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphascope {

// The value is mantissa · 10^-digits. The mantissa has no trailing zeros; 0 has digits 0.
struct Decimal {
  std::int64_t mantissa = 0;  // |mantissa| < 10^18
  std::int32_t digits = 0;    // decimal places; negative for multiples of 10, 100 …

  double to_double() const;
};

enum class DecimalStatus : std::uint8_t {
  ok,
  malformed,   // empty or not a number
  not_finite,  // nan, inf: some programs write these words
};

// Reads the whole text (no blanks around it): [+-]digits[.digits][(e|E)[+-]digits]. A Fortran D
// exponent counts as e. Digits after the 18th are cut, and the last digit is then made sticky.
// Rounding to any lattice therefore gives the result of the full text.
DecimalStatus parse_decimal(std::string_view text, Decimal& value);

// The remedy for a coordinate that was not read: `malformed` is that of the format.
const char* remedy_of_number(DecimalStatus status, const char* malformed);

// Printed digits behind the decimal point, with zeros: 6 for "1.000000".
int printed_decimals(std::string_view text);

// The value in units of 10^-digits, rounded half away from zero. It saturates at ±2^62. `rounding`
// receives |value - result| in units (0 when exact).
std::int64_t to_units(const Decimal& value, int digits, double& rounding);

}  // namespace alphascope
