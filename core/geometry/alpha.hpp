// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha as people write it, in Å²: a decimal number with at most 18 digits behind the point, kept
// exactly. Lattice::alpha_on_lattice() converts it into the threshold that decides membership.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/geometry/int128.hpp"

namespace alphascope {

// The bound on |alpha| in Å²: the square of 10^12 Å. On the finest lattice (six digits) it is 10^36
// square units, so alpha values fit single precision (3.4 · 10^38), and no file has "inf" in it.
// The engines themselves compute with any alpha, infinity included.
inline constexpr double kMaxAlphaAngstrom2 = 1e24;

class Alpha {
 public:
  static constexpr int kMostDigits = 18;  // behind the point
  static constexpr std::int64_t kParts = 1000000000000000000;

  constexpr Alpha() = default;
  // The shortest decimal that reads as this double, which is also what programs show of it. With
  // more than 18 digits behind the point, the nearest decimal with 18. So a slider's alpha is the
  // one that is shown. Beyond kMaxAlphaAngstrom2, infinite or NaN, it stays a double: is_decimal()
  // is false.
  Alpha(double angstrom2);  // NOLINT: implicit, so that a double can stand for an alpha

  enum class Reading : std::uint8_t {
    ok,
    malformed,
    too_fine,   // more than 18 digits behind the point, not counting zeros at the end
    too_large,  // beyond kMaxAlphaAngstrom2
  };
  // Reads the whole text: [+-]digits[.digits][(e|E)[+-]digits]. Sets `alpha` only if the result is
  // ok.
  static Reading read(std::string_view text, Alpha& alpha);

  // The value is whole() + fraction() / kParts, with 0 <= fraction() < kParts.
  bool is_decimal() const;
  Int128 whole() const { return whole_; }
  std::int64_t fraction() const { return fraction_; }

  // The nearest double, for pictures, sizes and approximate numbers; never for membership in
  // K_alpha.
  double nearest() const { return nearest_; }
  operator double() const { return nearest_; }  // NOLINT: as above
  // Is this the decimal that its nearest double stands for (see the constructor)?
  bool is_shortest_of_double() const { return *this == Alpha(nearest_); }
  // All digits, without an exponent: "-0.5".
  std::string digits() const;

  // Compares as numbers: NaN is equal to nothing.
  friend bool operator==(const Alpha& a, const Alpha& b) {
    return a.nearest_ == b.nearest_ && a.whole_ == b.whole_ && a.fraction_ == b.fraction_;
  }
  friend std::partial_ordering operator<=>(const Alpha& a, const Alpha& b);
  // Compares with a plain number, which stands for its shortest decimal.
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  friend bool operator==(const Alpha& a, Number b) { return a == Alpha(static_cast<double>(b)); }
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  friend std::partial_ordering operator<=>(const Alpha& a, Number b) {
    return a <=> Alpha(static_cast<double>(b));
  }

 private:
  Int128 whole_ = 0;
  std::int64_t fraction_ = 0;
  double nearest_ = 0;
};

// The number whole + fraction / Alpha::kParts with all its digits.
std::string decimal_text(Int128 whole, std::int64_t fraction);
// Reads such a number if its whole part has at most 37 digits, without Alpha's bound.
Alpha::Reading read_decimal(std::string_view text, Int128& whole, std::int64_t& fraction);

// Is the number within the bound? False for NaN.
inline bool is_valid_alpha(double angstrom2) {
  return angstrom2 >= -kMaxAlphaAngstrom2 && angstrom2 <= kMaxAlphaAngstrom2;
}

}  // namespace alphascope
