// The range of a chart's axis, and its ticks.
#pragma once

#include <algorithm>
#include <cmath>

namespace alphascope {

struct PlotRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double share(double value) const { return (value - low) / (high - low); }
};

// Distance of ticks: 1, 2 or 5 times a power of ten, with at most `most` distances in the range.
inline double tick_step(const PlotRange& range, int most) {
  const double least = (range.high - range.low) / std::max(most, 1);
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= least) return step * power;
  }
  return 10 * power;
}

template <class Use>
void for_ticks(const PlotRange& range, double step, const Use& use) {
  const auto last = static_cast<long>(std::floor(range.high / step));
  for (auto n = static_cast<long>(std::ceil(range.low / step)); n <= last; ++n) {
    use(static_cast<double>(n) * step);
  }
}

}  // namespace alphascope
