// SPDX-License-Identifier: GPL-3.0-or-later
// Sums that do not depend on the order of their terms.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "core/predicates/wide_int.hpp"

namespace alphascope {

// Like FixedSum (exact_sum.hpp), in 128 bits. For terms up to 2^bits a unit is 2^(bits - 90), and
// 2^36 terms fit.
class WideFixedSum {
 public:
  // Units per 1, equal for every add() and value() of one sum.
  static double scale(int bits) { return std::ldexp(1.0, 90 - bits); }

  void add(double x, double scale) { units_ += static_cast<Int128>(x * scale); }
  void add(const WideFixedSum& other) { units_ += other.units_; }
  double value(double scale) const { return static_cast<double>(units_) / scale; }

 private:
  friend class SharedFixedSum;
  Int128 units_ = 0;
};

// The same sum, to which any thread may add. The lower half carries into the upper one by its own
// additions, so no addition is lost.
class SharedFixedSum {
 public:
  void clear() { low_ = high_ = 0; }
  void add(double x, double scale) {
    const auto units = static_cast<unsigned __int128>(static_cast<Int128>(x * scale));
    const auto low = static_cast<std::uint64_t>(units);
    const std::uint64_t before = std::atomic_ref(low_).fetch_add(low, std::memory_order_relaxed);
    const std::uint64_t carry = before + low < low ? 1 : 0;
    const std::uint64_t high = static_cast<std::uint64_t>(units >> 64) + carry;
    if (high != 0) std::atomic_ref(high_).fetch_add(high, std::memory_order_relaxed);
  }
  // When all additions are done.
  double value(double scale) const {
    WideFixedSum sum;
    sum.units_ = static_cast<Int128>(static_cast<unsigned __int128>(high_) << 64 | low_);
    return sum.value(scale);
  }

 private:
  std::uint64_t low_, high_;  // not initialised, like all elements of result arrays
};

}  // namespace alphascope
