// SPDX-License-Identifier: GPL-3.0-or-later
// The legends of a picture: meanings of the colours of its balls and simplices.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/theme.hpp"

namespace alphascope {

struct ColourMeaning;

// A legend of a quantity has `stops`. A legend of categories has `entries`. A quantity has an entry
// as well if some objects have no value.
struct ColourLegend {
  struct Stop {
    Colour colour;
    double value = 0;  // in the unit stated in the title
  };
  struct Entry {
    Colour colour;
    std::string name;
  };
  std::string title;        // "alpha value (Å²), square-root scale"
  std::vector<Stop> stops;  // evenly spaced on the colour map, smallest value first
  std::vector<Entry> entries = {};
};

ColourLegend legend_of(const ColourMeaning& key);

// Legends of balls and of simplices, in this order. Without a key there is no legend. If both keys
// are equal there is one legend; otherwise each title begins with "balls: " or "simplices: ".
std::vector<ColourLegend> legends_of(const std::optional<ColourMeaning>& balls,
                                     const std::optional<ColourMeaning>& simplices);

}  // namespace alphascope
