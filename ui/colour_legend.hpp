// The legends of a picture: what the colours of its balls and of its simplices mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/measures/paint_balls.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// Of a quantity, `stops`; of categories, and of what has no value, `entries`.
struct ColourLegend {
  struct Stop {
    Colour colour;
    double value = 0;  // in the unit that the title says
  };
  struct Entry {
    Colour colour;
    std::string name;
  };
  std::string title;        // "alpha value (Å²), square-root scale"
  std::vector<Stop> stops;  // evenly along the colour map, smallest value first
  std::vector<Entry> entries = {};
};

ColourLegend legend_of(const PaintKey& key);

// None of what is not drawn, or drawn in one colour. One legend where both mean the same; where
// they do not, each says whose it is. Those of the balls come first.
std::vector<ColourLegend> legends_of(const std::optional<PaintKey>& balls,
                                     const std::optional<PaintKey>& simplices);

}  // namespace alphascope
