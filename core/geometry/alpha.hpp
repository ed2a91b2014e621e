// Alpha as people write it, in Å²: a decimal number of at most 18 digits behind the point, kept
// exactly. What decides membership is made of it by Lattice::alpha_on_lattice().
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/geometry/int128.hpp"

namespace alphascope {

// Alpha lies between -kMaxAlphaAngstrom2 and this, in Å²: a sphere of 10^12 Å. On the finest
// lattice (six digits) it is 10^36 square units, so alpha values fit single precision (3.4 · 10^38)
// and no file says "inf". The engines themselves compute with any alpha, infinity included.
inline constexpr double kMaxAlphaAngstrom2 = 1e24;

class Alpha {
 public:
  static constexpr int kMostDigits = 18;  // behind the point
  static constexpr std::int64_t kParts = 1000000000000000000;

  constexpr Alpha() = default;
  // The shortest decimal that reads as this double, which is what programs show of it; of more than
  // 18 digits behind the point, the nearest of 18. So a slider's alpha is the one that it shows.
  // Beyond kMaxAlphaAngstrom2 it stays a double, infinite or NaN too: is_decimal() is false.
  Alpha(double angstrom2);  // NOLINT: wherever a double is meant as alpha

  enum class Reading : std::uint8_t {
    ok,
    malformed,
    too_fine,   // more than 18 digits behind the point, zeros at their end aside
    too_large,  // beyond kMaxAlphaAngstrom2
  };
  // The whole text: [+-]digits[.digits][(e|E)[+-]digits]. `alpha` is left alone unless it is ok.
  static Reading read(std::string_view text, Alpha& alpha);

  // The value is whole() + fraction() / kParts, with 0 <= fraction() < kParts.
  bool is_decimal() const;
  Int128 whole() const { return whole_; }
  std::int64_t fraction() const { return fraction_; }

  // The nearest double: for pictures, sizes and near numbers, never for what is in K_alpha.
  double nearest() const { return nearest_; }
  operator double() const { return nearest_; }  // NOLINT: as above
  // Is it all that its nearest double says (see the constructor)?
  bool is_shortest_of_double() const { return *this == Alpha(nearest_); }
  // All digits, without an exponent: "-0.5".
  std::string digits() const;

  // As numbers: NaN is equal to nothing.
  friend bool operator==(const Alpha& a, const Alpha& b) {
    return a.nearest_ == b.nearest_ && a.whole_ == b.whole_ && a.fraction_ == b.fraction_;
  }
  friend std::partial_ordering operator<=>(const Alpha& a, const Alpha& b);
  // With a plain number, which is meant as a decimal again.
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

// whole + fraction / Alpha::kParts with all its digits.
std::string decimal_text(Int128 whole, std::int64_t fraction);
// The other way, for whole parts of at most 37 digits: without Alpha's bound.
Alpha::Reading read_decimal(std::string_view text, Int128& whole, std::int64_t& fraction);

// Also false for NaN.
inline bool is_alpha(double angstrom2) {
  return angstrom2 >= -kMaxAlphaAngstrom2 && angstrom2 <= kMaxAlphaAngstrom2;
}

}  // namespace alphascope
