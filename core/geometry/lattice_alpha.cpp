// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha on the lattice between two doubles: splitting, rounding and text.
#include "core/geometry/lattice_alpha.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace alphascope {
namespace {

int bits_of(UInt128 value) {
  int bits = 0;
  for (; value != 0; value >>= 1) ++bits;
  return bits;
}

// The largest double of at most 53 bits that is not above whole + fraction / kParts, and the rest.
// The number must not be 0.
struct Split {
  double base, rest;
  bool exact;
};
Split split(UInt128 whole, std::int64_t fraction) {
  constexpr double kParts = 1e18;
  const int bits = bits_of(whole);
  if (bits > 53) {
    const int low_bits = bits - 53;
    const UInt128 low = whole & ((UInt128{1} << low_bits) - 1);
    return {std::ldexp(static_cast<double>(whole >> low_bits), low_bits),
            static_cast<double>(low) + static_cast<double>(fraction) / kParts,
            low == 0 && fraction == 0};
  }
  // Shift so that there are 53 bits in all. The product needs at most 53 + 60 bits, as 10^18 <
  // 2^60.
  int shift = 53 - bits;
  if (whole == 0) {
    while ((static_cast<UInt128>(fraction) << (shift - 52)) < static_cast<UInt128>(Alpha::kParts)) {
      ++shift;
    }
  }
  const UInt128 scaled = static_cast<UInt128>(fraction) << shift;
  const UInt128 quotient = scaled / Alpha::kParts, remainder = scaled % Alpha::kParts;
  return {std::ldexp(static_cast<double>((whole << shift) + quotient), -shift),
          std::ldexp(static_cast<double>(remainder) / kParts, -shift), remainder == 0};
}

std::string shortest_text(double value) {
  char text[48];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

LatticeAlpha LatticeAlpha::of(Int128 whole, std::int64_t fraction) {
  if (whole == 0 && fraction == 0) return {};
  const bool negative = whole < 0;
  UInt128 size = static_cast<UInt128>(negative ? -whole : whole);
  std::int64_t parts = fraction;
  if (negative && fraction > 0) {
    --size;
    parts = Alpha::kParts - fraction;
  }
  const Split found = split(size, parts);
  const double sign = negative ? -1 : 1;
  LatticeAlpha alpha(sign * found.base);
  if (found.exact) return alpha;
  const double beyond = sign * std::nextafter(found.base, std::numeric_limits<double>::infinity());
  (negative ? alpha.below : alpha.above) = beyond;
  alpha.rest = sign * found.rest;
  alpha.whole = whole;
  alpha.fraction = fraction;
  return alpha;
}

double LatticeAlpha::nearest() const {
  if (is_double()) return below;
  const double other = base == below ? above : below;
  return std::fabs(rest) <= std::fabs(other - base) / 2 ? base : other;
}

bool LatticeAlpha::is_shortest_of_double() const {
  if (is_double()) return true;
  Int128 shortest = 0;
  std::int64_t parts = 0;
  return read_decimal(shortest_text(nearest()), shortest, parts) == Alpha::Reading::ok &&
         shortest == whole && parts == fraction;
}

std::string LatticeAlpha::text() const {
  return is_double() ? shortest_text(below) : decimal_text(whole, fraction);
}

float LatticeAlpha::nearest_float() const {
  const auto low = static_cast<float>(below), high = static_cast<float>(above);
  if (low == high) return low;
  // The middle between two floats is a double, so it is `below` or `above`, and alpha is not equal
  // to it.
  const double half = 0.5 * (static_cast<double>(low) + static_cast<double>(high));
  return below == half ? high : low;
}

}  // namespace alphascope
