// SPDX-License-Identifier: GPL-3.0-or-later
// The scale from values of a quantity to colours, and to the numbers beside them.
#pragma once

#include <vector>

#include "core/chart/colour_map.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct ColourRange {
  double low = 0, high = 1;  // low < high
  friend bool operator==(const ColourRange&, const ColourRange&) = default;
};

struct ColourScale {
  ColourMap map = ColourMap::viridis;
  ColourRange range;
  // Whether the scale takes square roots, which spread out the many small values.
  bool root = false;

  // The share of a value along the map, 0 to 1. Values beyond the range give 0 or 1. An empty range
  // gives 0.5.
  double share(double value) const;
  double value(double share) const;
  Rgb8 colour(double value) const { return mapped_colour(map, share(value)); }
  friend bool operator==(const ColourScale&, const ColourScale&) = default;
};

// The smallest range with round ends that contains `low` and `high`. If these are equal, they are
// in its middle; if both are 0, at its lower end.
ColourRange round_range(double low, double high);

}  // namespace alphascope
