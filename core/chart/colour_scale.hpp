// From the values of a quantity to colours, and to the numbers beside them.
#pragma once

#include <vector>

#include "core/chart/colour_map.hpp"

namespace alphascope {

struct ColourRange {
  double low = 0, high = 1;  // low < high
  friend bool operator==(const ColourRange&, const ColourRange&) = default;
};

struct ColourScale {
  ColourMap map = ColourMap::viridis;
  ColourRange range;
  bool root = false;  // the square root spreads small values, which nearly all are

  // 0 to 1, along the map; 0 or 1 for values beyond the range. The middle of an empty range.
  double share(double value) const;
  double value(double share) const;
  Rgb8 colour(double value) const { return mapped_colour(map, share(value)); }
  friend bool operator==(const ColourScale&, const ColourScale&) = default;
};

// The least range with round ends that holds all values from `low` to `high`, which may be equal:
// then they are in its middle, or at its lower end where they are 0.
ColourRange round_range(double low, double high);

// Multiples of `step` within the range, ascending.
std::vector<double> round_values(const ColourRange& range, double step);

}  // namespace alphascope
