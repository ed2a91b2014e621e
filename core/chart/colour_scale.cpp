// SPDX-License-Identifier: GPL-3.0-or-later
// Converts values to shares of a colour map and back, and makes round ranges.
#include "core/chart/colour_scale.hpp"

#include <algorithm>
#include <cmath>

#include "core/chart/ticks.hpp"

namespace alphascope {
namespace {

constexpr int kStepsOfARange = 5;
// Tolerance in steps, so that a range that ends at a round decimal number keeps it despite
// rounding.
constexpr double kSlack = 1e-9;

}  // namespace

double ColourScale::share(double value) const {
  if (!(range.high > range.low)) return 0.5;
  const double linear = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
  return root ? std::sqrt(linear) : linear;
}

double ColourScale::value(double share) const {
  return range.low + (root ? share * share : share) * (range.high - range.low);
}

ColourRange round_range(double low, double high) {
  if (low == high) {
    if (low == 0) return {0, 1};
    const double beside = nice_step(std::fabs(low), 2);
    return {low - beside, high + beside};
  }
  const double step = nice_step(high - low, kStepsOfARange);
  return {std::floor(low / step + kSlack) * step, std::ceil(high / step - kSlack) * step};
}

}  // namespace alphascope
