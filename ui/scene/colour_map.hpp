// The colours of quantities, from dark to bright: told apart by all eyes, and in grey.
#pragma once

#include <functional>
#include <string>

#include "ui/picture_marks.hpp"
#include "ui/scene/ball_geometry.hpp"

namespace alphascope {

// Viridis; 0 dark, 1 bright.
Rgb8 mapped_colour(double share);

// `value` of each share along the map, 0 to 1.
ColourLegend map_legend(std::string title, const std::function<double(double)>& value);

}  // namespace alphascope
