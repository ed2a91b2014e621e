// SPDX-License-Identifier: GPL-3.0-or-later
// Sums that do not depend on the order of their terms, nor on the threads that add them.
#pragma once

#include <math.h>

#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// A sum as an integer multiple of a power of two. Integers add up exactly in any order, even if
// carries beyond 64 bits are lost, as long as the whole sum fits. A term is truncated to whole
// units.
using FixedSum = std::uint64_t;

// The least e with x <= 2^e; x > 0.
ALPHASCOPE_INLINE int bits_above(double x) {
  int exponent;
  frexp(x, &exponent);
  return exponent;
}
// Units per 1 for terms of magnitude up to 2^bits, which then have up to 2^61 units.
ALPHASCOPE_INLINE double fixed_scale(int bits) {
  return ldexp(1.0, 61 - bits);
}
ALPHASCOPE_INLINE FixedSum fixed_term(double x, double scale) {
  constexpr double kMost = 4.611686018427387904e18;  // 2^62, above every correct term
  double units = x * scale;
  units = units < kMost ? units : kMost;
  units = units > -kMost ? units : -kMost;
  return static_cast<FixedSum>(static_cast<std::int64_t>(units));
}
ALPHASCOPE_INLINE double fixed_value(FixedSum sum, double scale) {
  return static_cast<double>(static_cast<std::int64_t>(sum)) / scale;
}

// A compensated sum: A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher
// Summen" (1974). Its error hardly grows with the number of terms. It depends on their order.
struct NeumaierSum {
  double sum = 0, lost = 0;

  ALPHASCOPE_INLINE void add(double x) {
    const double next = sum + x;
    lost += fabs(sum) >= fabs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  ALPHASCOPE_INLINE double value() const { return sum + lost; }
};

}  // namespace alphascope
