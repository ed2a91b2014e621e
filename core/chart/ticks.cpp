// SPDX-License-Identifier: GPL-3.0-or-later
// Computes round numbers on an axis.
#include "core/chart/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/chart/readable_number.hpp"

namespace alphascope {
namespace {

constexpr double kSlack = 1e-9;  // of a step; an end that is a multiple counts despite rounding

}  // namespace

double nice_step(double span, int most) {
  const double rough = span / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(std::max(rough, 1e-300))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - kSlack)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> round_values(double low, double high, double step) {
  constexpr double kMost = 1000;
  std::vector<double> values;
  const double first = std::ceil(low / step - kSlack);
  const double last = std::floor(high / step + kSlack);
  if (!(last - first < kMost)) return values;
  for (double k = first; k <= last; ++k) values.push_back(k == 0 ? 0 : k * step);
  return values;
}

std::string tick_text(double value, double step) {
  constexpr double kMostInDigits = 1e9, kLeastInDigits = 1e-6;
  if (std::fabs(value) >= kMostInDigits || step < kLeastInDigits) return chart_number(value);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + kSlack)));
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return separated_number(text);
}

}  // namespace alphascope
