// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha in square lattice units, exactly: the threshold for ortho-radii in every engine. Filters
// compare with the doubles on both sides of it, integers with the number itself. Host and device.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/host_device.hpp"

namespace alphascope {

struct LatticeAlpha {
  // The nearest doubles below and above alpha. If alpha is a double, both are equal to it, and the
  // members that follow are not used.
  double below = 0, above = 0;
  // `base` is the one of these that is nearer to zero. `rest` is alpha - base, within 3 u of its
  // value.
  double base = 0, rest = 0;
  // Alpha is whole + fraction / Alpha::kParts, with 0 <= fraction < kParts.
  Int128 whole = 0;  // |whole| <= 10^36 < 2^120
  std::int64_t fraction = 0;

  LatticeAlpha() = default;
  // Any double without rounding, infinity included.
  ALPHASCOPE_HOST_DEVICE LatticeAlpha(double square_units)  // NOLINT: implicit
      : below(square_units), above(square_units), base(square_units) {}
  // The number whole + fraction / kParts.
  static LatticeAlpha of(Int128 whole, std::int64_t fraction);

  ALPHASCOPE_HOST_DEVICE bool is_double() const { return below == above; }
  // The nearest double, for pictures, sizes and approximate numbers.
  double nearest() const;
  // Is alpha the shortest decimal that reads as its nearest double?
  bool is_shortest_of_double() const;
  // All digits. For a double, as few digits as identify it.
  std::string text() const;
  // Correctly rounded, halves to even. Rounding by way of a double would give the wrong float for
  // some halves.
  float nearest_float() const;

  // weight + alpha within 3 u of its value and with the right sign; 0 only if the sum is 0.
  // Requires 0 <= weight < 2^52.
  ALPHASCOPE_HOST_DEVICE double plus(std::int64_t weight) const {
    const double w = static_cast<double>(weight), sum = w + base;
    if (is_double()) return sum;
    // `lost` is the rounding error of the sum (D. Knuth's TwoSum), with alpha - base still missing.
    // `rest` errs by 3 u of 2 u |alpha|, and this sum by about u of 2 u |alpha|. If they cancel,
    // |alpha| < 2^53, so both errors are below 2^-50. A result above 4 then has 3 u to spare, its
    // own rounding included.
    const double part = sum - w;
    const double lost = (w - (sum - part)) + (base - part);
    const double near = sum + (lost + rest);
    if (near >= 4 || near <= -4) return near;
    // The sum is below 2^63 in units of 1 / kParts.
    const Int128 parts = (whole + weight) * Alpha::kParts + fraction;
    return static_cast<double>(static_cast<std::int64_t>(parts)) / 1e18;
  }

  // Compares as numbers: NaN is equal to nothing.
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
