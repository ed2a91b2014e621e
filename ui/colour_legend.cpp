// SPDX-License-Identifier: GPL-3.0-or-later
// Makes legends from the keys of balls and simplices.
#include "ui/colour_legend.hpp"

#include "core/chart/colour_map.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {

ColourLegend legend_of(const ColourMeaning& key) {
  ColourLegend legend{key.title, {}, {}};
  for (const PaintCategory& category : key.categories) {
    legend.entries.push_back({to_colour(category.colour), category.name});
  }
  if (!key.scale) return legend;
  constexpr int kStops = 65;
  for (int i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    const double value = key.scale->value(share);
    legend.stops.push_back({to_colour(mapped_colour(key.scale->map, share)), value});
  }
  return legend;
}

std::vector<ColourLegend> legends_of(const std::optional<ColourMeaning>& balls,
                                     const std::optional<ColourMeaning>& simplices) {
  std::vector<ColourLegend> legends;
  if (balls) legends.push_back(legend_of(*balls));
  if (simplices && simplices != balls) legends.push_back(legend_of(*simplices));
  if (legends.size() == 2) {
    legends[0].title = "balls: " + legends[0].title;
    legends[1].title = "simplices: " + legends[1].title;
  }
  return legends;
}

}  // namespace alphascope
