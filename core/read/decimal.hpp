// Decimal numbers of text files, kept exact: no binary floating point between file and lattice.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphascope {

// The value is mantissa · 10^-digits, without trailing zeros in the mantissa (0 has digits 0).
struct Decimal {
  std::int64_t mantissa = 0;  // |mantissa| < 10^18
  std::int32_t digits = 0;    // decimal places; negative for multiples of 10, 100…

  double to_double() const;
};

enum class DecimalStatus : std::uint8_t {
  ok,
  malformed,   // empty, or something that is not a number
  not_finite,  // nan, inf: words that some programs write
};

// Reads the whole text (no blanks around it): [+-]digits[.digits][(e|E)[+-]digits]. A Fortran D
// exponent counts as e. More than 18 significant digits are cut with a sticky last digit, so that
// rounding to any lattice still gives what the full text would have given.
DecimalStatus parse_decimal(std::string_view text, Decimal& value);

// Digits behind the point as they are printed, zeros too: 6 of "1.000000".
int printed_decimals(std::string_view text);

// The value in units of 10^-digits, rounded half away from zero; saturates at ±2^62.
// rounding receives |value - result| in units (0 when exact).
std::int64_t to_units(const Decimal& value, int digits, double& rounding);

}  // namespace alphascope
