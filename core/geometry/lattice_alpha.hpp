// Alpha in square lattice units, exactly: the threshold that every engine compares ortho-radii
// with. Filters look at the doubles on both sides of it, integers at the number itself. Host and
// device.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/host_device.hpp"
#include "core/geometry/int128.hpp"

namespace alphascope {

struct LatticeAlpha {
  // The nearest doubles below and above; where it is a double itself, both are that, and what
  // follows is not looked at.
  double below = 0, above = 0;
  // Of those the one nearer to zero, and what is left of alpha then, within 3 u of that.
  double base = 0, rest = 0;
  // Alpha is whole + fraction / Alpha::kParts, with 0 <= fraction < kParts.
  Int128 whole = 0;  // |whole| <= 10^36 < 2^120
  std::int64_t fraction = 0;

  LatticeAlpha() = default;
  // Any double, infinite too, as it is.
  ALPHASCOPE_HOST_DEVICE LatticeAlpha(double square_units)  // NOLINT: every double is one
      : below(square_units), above(square_units), base(square_units) {}
  // whole + fraction / kParts, as above.
  static LatticeAlpha of(Int128 whole, std::int64_t fraction);

  ALPHASCOPE_HOST_DEVICE bool is_double() const { return below == above; }
  // For pictures, sizes and near numbers.
  double nearest() const;
  // Is it all that its nearest double says, by the shortest decimal that reads as that?
  bool is_shortest_of_double() const;
  // All digits; of a double, as few as say which one it is.
  std::string text() const;
  // Correctly rounded, halves to even: by way of a double, some halves would fall to the wrong
  // side.
  float nearest_float() const;

  // weight + alpha within 3 u of it, with the right sign; 0 only when it is 0. 0 <= weight < 2^52.
  ALPHASCOPE_HOST_DEVICE double plus(std::int64_t weight) const {
    const double w = static_cast<double>(weight), sum = w + base;
    if (is_double()) return sum;
    // What the sum lost (D. Knuth's TwoSum), and what base lacks. `rest` errs by 3 u of 2 u |alpha|
    // and this sum by u of 2 u |alpha| or so. If they cancel, |alpha| < 2^53, so both are below
    // 2^-50; a result above 4 has 3 u to spare, its own rounding included.
    const double part = sum - w;
    const double lost = (w - (sum - part)) + (base - part);
    const double near = sum + (lost + rest);
    if (near >= 4 || near <= -4) return near;
    // Below 2^63 in units of 1 / kParts.
    const Int128 parts = (whole + weight) * Alpha::kParts + fraction;
    return static_cast<double>(static_cast<std::int64_t>(parts)) / 1e18;
  }

  // As numbers: NaN is equal to nothing.
  friend bool operator==(const LatticeAlpha& a, const LatticeAlpha& b) { return (a <=> b) == 0; }
  friend std::partial_ordering operator<=>(const LatticeAlpha& a, const LatticeAlpha& b) {
    if (const auto order = a.below <=> b.below; order != 0) return order;
    if (const auto order = a.above <=> b.above; order != 0) return order;
    if (a.is_double()) return std::partial_ordering::equivalent;
    if (const auto order = a.whole <=> b.whole; order != 0) return order;
    return a.fraction <=> b.fraction;
  }
};

}  // namespace alphascope
