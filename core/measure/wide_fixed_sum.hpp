// SPDX-License-Identifier: GPL-3.0-or-later
// Sums on one thread that do not depend on the order of their terms.
#pragma once

#include <cmath>

#include "core/predicates/wide_int.hpp"

namespace alphascope {

// Like FixedSum (exact_sum.hpp), in 128 bits. For terms up to 2^bits a unit is 2^(bits - 90), and
// 2^36 terms fit.
class WideFixedSum {
 public:
  // Units per 1, equal for every add() and value() of one sum.
  static double scale(int bits) { return std::ldexp(1.0, 90 - bits); }

  void add(double x, double scale) { units_ += static_cast<Int128>(x * scale); }
  double value(double scale) const { return static_cast<double>(units_) / scale; }

 private:
  Int128 units_ = 0;
};

}  // namespace alphascope
